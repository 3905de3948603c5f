// What methods are compared on: scenes, and the frames of them that are drawn.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::bench {

struct Subject {
    std::string name;
    scene::Scene scene;
    std::vector<int> frames{1};
};

// The surfaces for which the paper's Table I prints a rate, in its order (paper_tables.toml).
std::vector<std::string> table_1();

// A surface of the catalogue at its defaults, the whole of it in the picture. Throws SceneError.
Subject surface(const std::string& name);

// The same with so many lights from all around, each of which casts shadows.
Subject lit(const std::string& name, int lights);

// An animation of the gallery. Throws SceneError.
Subject animation(const std::string& name, std::vector<int> frames);

// `count` Gaussian blobs spread evenly over the unit ball. As many more as there are they are
// smaller, and step and threshold on dF/dt follow: every count is the same picture in finer grain,
// and 75 are as large as Blinn's in the catalogue.
Subject blobs(int count);

} // namespace isomotion::bench
