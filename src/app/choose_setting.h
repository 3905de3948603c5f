// Implements --max-wrong: finds the cheapest method and step that are accurate enough.
#pragma once

#include <optional>
#include <vector>

#include "gpu/context.h"
#include "render/stage.h"
#include "scene/scene.h"

namespace isomotion::app {

struct SettingChoice {
    double max_wrong = 0; // pixels in a million
    bool keeps_method = false;
    render::StageChoice stage = render::StageChoice::fragment;
    bool quiet = false;
};

// Chooses a setting for each surface, the first one's first. Measures against certified truth on up
// to three of the frames, in a smaller picture. If there are several surfaces, each is measured
// alone and gets as large a part of the wrong pixels as the others; then all are measured together.
// None if no setting is accurate enough.
std::optional<std::vector<scene::Isolation>> choose_settings(gpu::Context& context,
                                                             const scene::Scene& scene,
                                                             const std::vector<int>& frames,
                                                             const SettingChoice& choice);

} // namespace isomotion::app
