// The colours of a material, read back from pictures under black lights.
#pragma once

#include <string>
#include <vector>

#include "render/drawing.h"

namespace isomotion::render {

// Black lights leave what comes from everywhere: 0.12 of the material's colour.
inline constexpr double ambient = 0.12;
inline const std::string dark = "[[lights]]\ndirection = [0, 0, 1]\ncolor = [0, 0, 0]\n";

struct Pixel {
    glm::dvec3 color, position, normal;
    double evaluations = 0; // where the picture has them
};

inline std::vector<Pixel> hits_of(const Picture& picture) {
    const auto sample = [&](const char* name, std::size_t k) {
        return double(picture.frame.find(name)->samples[k]);
    };
    const bool counts = picture.frame.find("evaluations") != nullptr;
    std::vector<Pixel> hits;
    for (std::size_t k = 0; k < picture.frame.find("R")->samples.size(); ++k) {
        if (Verdict(int(sample("verdict", k))) != Verdict::hit) continue;
        hits.push_back({glm::dvec3(sample("R", k), sample("G", k), sample("B", k)) / ambient,
                        {sample("P.X", k), sample("P.Y", k), sample("P.Z", k)},
                        {sample("N.X", k), sample("N.Y", k), sample("N.Z", k)},
                        counts ? sample("evaluations", k) : 0});
    }
    return hits;
}

} // namespace isomotion::render
