// The pictures that a frame is made of.
#pragma once

#include "render/sample_pattern.h"
#include "scene/light_points.h"
#include "scene/scene_at.h"

namespace isomotion::render {

// Calls take(now, aim) for every picture of a frame. The first is at the frame's time. Throws
// SceneError if a value leaves its range.
template<class Take> void for_each_picture(const scene::Scene& scene, int frame, Take&& take) {
    const auto take_lit = [&](const scene::SceneAt& now, const scene::Aim& aim) {
        if (scene::is_lit_by_discs(now)) {
            take(scene::lit_from(now, aim.lens), aim);
        } else {
            take(now, aim);
        }
    };
    const scene::SceneAt first = scene::at_frame(scene, frame);
    for (const Sample& sample : sample_pattern(scene.output.samples)) {
        const double part = scene.camera.shutter * sample.part;
        if (part == 0) {
            take_lit(first, sample.aim);
        } else {
            take_lit(scene::at_frame(scene, frame, part), sample.aim);
        }
    }
}

} // namespace isomotion::render
