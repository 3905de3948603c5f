// Scenes written as text, seen by the certified ray caster.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "roots/certify.h"
#include "scene/reading/load.h"

namespace isomotion::roots {

inline scene::Scene scene_of(const std::string& text) {
    const auto file =
        std::filesystem::temp_directory_path() / fmt::format("isomotion-truth-{}.toml", getpid());
    std::ofstream(file) << text;
    scene::Scene scene = scene::load(file.string());
    std::filesystem::remove(file);
    return scene;
}

// A frame of a scene, with the tube and the first root of each pixel.
struct View {
    scene::Scene scene;
    scene::SceneAt now;
    int width, height;
    std::vector<Tube> tubes;
    std::vector<FirstRoot> roots;

    View(scene::Scene of, int columns, int rows, Budget budget = {}, int frame = 1)
        : scene(std::move(of))
        , now(scene::at_frame(scene, frame))
        , width(columns)
        , height(rows) {
        const Tubes all(now, width, height);
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) tubes.push_back(all.at(column, row));
        }
        const formula::EnclosurePrograms field =
            formula::enclosure_programs(*scene.surfaces[0].field);
        roots.resize(tubes.size());
        RootFinder(field, now.surfaces[0], budget).find(tubes, roots);
    }
};

inline const char* name(Answer answer) {
    constexpr const char* names[] = {"miss", "hit", "touching", "undecided"};
    return names[int(answer)];
}

inline void PrintTo(const FirstRoot& root, std::ostream* out) {
    *out << fmt::format("{}{} [{:.9g}, {:.9g}], touching [{:.9g}, {:.9g}]", name(root.answer),
                        root.after_is_hit ? " then hit" : "", root.low, root.high, root.touch_low,
                        root.touch_high);
}

// Whether an answer may be given for a tube whose middle ray has these roots, sorted: what is said
// of all rays of a tube must hold for that one. Roots outside of [near, far] don't count. A root
// may be off by `slack`.
inline testing::AssertionResult holds(const FirstRoot& root, const Tube& tube,
                                      std::vector<double> zeros, double slack = 0) {
    std::erase_if(zeros, [&](double t) { return t < tube.near + slack || t > tube.far - slack; });
    const auto none_between = [&](double from, double to) {
        return std::none_of(zeros.begin(), zeros.end(),
                            [&](double t) { return t > from + slack && t < to - slack; });
    };
    const auto some_in = [&](double from, double to) {
        return std::any_of(zeros.begin(), zeros.end(),
                           [&](double t) { return t >= from - slack && t <= to + slack; });
    };
    const double end = tube.far + 1;
    const double first = tube.near - 1;
    bool right = true;
    switch (root.answer) {
    case Answer::miss:
        right = none_between(first, end);
        break;
    case Answer::hit:
        right =
            root.low <= root.high && none_between(first, root.low) && some_in(root.low, root.high);
        break;
    case Answer::touching:
        right = root.touch_low <= root.touch_high && none_between(first, root.touch_low) &&
                none_between(root.touch_high, root.after_is_hit ? root.low : end) &&
                (!root.after_is_hit || some_in(root.low, root.high));
        break;
    case Answer::undecided:
        right = none_between(first, root.low);
        break;
    }
    if (right) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << testing::PrintToString(root) << " of a ray in [" << tube.near << ", " << tube.far
           << "] with roots at " << testing::PrintToString(zeros);
}

// One ray along z through (x, y), so that t is z: orthographic, one pixel of this width.
struct Axial {
    double x = 0, y = 0;
    double pixel = 0x1p-10;
    bool backwards = false; // along -z: t is -z
    std::string bounds = "{ sphere = 1.5 }";
    bool jumps_are_walls = false;
};

inline View along_z(const std::string& formula, const Axial& ray = {}) {
    const double side = ray.backwards ? 5 : -5;
    return View(scene_of(fmt::format(R"(
[surface]
formula = '''{}'''
bounds = {}
jumps = {}
[camera]
position = [{}, {}, {}]
target = [{}, {}, 0]
projection = "orthographic"
height = {}
)",
                                     formula, ray.bounds, ray.jumps_are_walls, ray.x, ray.y, side,
                                     ray.x, ray.y, ray.pixel)),
                1, 1);
}

// The surface at rest, square, before this camera.
inline View picture(const std::string& formula, const std::string& camera, int side = 32,
                    const std::string& bounds = "{ sphere = 1.5 }") {
    return View(scene_of(fmt::format("[surface]\nformula = '''{}'''\nbounds = {}\n[camera]\n{}\n",
                                     formula, bounds, camera)),
                side, side);
}

inline constexpr const char* from_aside =
    "position = [2.1, -1.7, 3.3]\ntarget = [0.1, 0, 0]\nfov = 40";

// Roots on the sphere about the origin.
inline std::vector<double> on_sphere(const Tube& tube, double radius) {
    const double middle = -glm::dot(tube.anchor, tube.direction);
    const glm::dvec3 foot = tube.anchor + middle * tube.direction;
    const double square = radius * radius - glm::dot(foot, foot);
    if (square < 0) return {};
    return {middle - std::sqrt(square), middle + std::sqrt(square)};
}

} // namespace isomotion::roots
