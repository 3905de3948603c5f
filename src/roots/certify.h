// The truth about a picture: the first root along every pixel's ray, certified on the CPU without
// GL.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "roots/first_root.h"
#include "scene/scene.h"

namespace isomotion::roots {

struct Truth {
    int width = 0, height = 0;
    std::vector<FirstRoot> roots; // rows from the top
    std::int64_t evaluations = 0;

    const FirstRoot& at(int column, int row) const {
        return roots[std::size_t(row) * std::size_t(width) + std::size_t(column)];
    }
    std::array<std::int64_t, 4> counts() const; // by Answer
};

struct Certifying {
    Budget budget;
    int threads = 0; // 0: as many as the machine runs at once
    // Called from one thread at a time, with `part` in [0, 1].
    std::function<void(double part)> progress;
};

// The result is the same for any number of threads. With several surfaces it is the truth about
// all, in the first one's coordinates.
Truth certify(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
              const Certifying& how = {});

} // namespace isomotion::roots
