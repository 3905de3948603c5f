// The pictures that a frame is made of.
#pragma once

#include "render/sample_pattern.h"
#include "scene/light_points.h"
#include "scene/scene_at.h"

namespace isomotion::render {

// Calls take(now, aim) for every picture of a frame, the one at its time first, at which the
// animation has `values`. Throws SceneError where a value leaves its range.
template<class Take>
void for_each_picture(const scene::Scene& scene, int frame, const animation::Values& values,
                      Take&& take) {
    const scene::SceneAt first = scene::at(scene, values);
    for (const Sample& sample : sample_pattern(scene.output.samples)) {
        const double part = scene.camera.shutter * sample.part;
        if (part == 0) {
            take(scene::lit_from(first, sample.aim.lens), sample.aim);
        } else {
            take(scene::lit_from(scene::at(scene, scene.timeline.values(frame, part)),
                                 sample.aim.lens),
                 sample.aim);
        }
    }
}

} // namespace isomotion::render
