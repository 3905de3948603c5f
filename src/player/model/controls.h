// A scene's parameters as sliders, and the animation that results from them.
//
// An override replaces a track's keys or expression by a number, as if the scene file stated it,
// and expressions that name the track follow. Fields of an array's elements are multiplied as a
// whole. apply() makes a new animation; formula and shaders stay.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::player {

// Values that a person set to replace the scene's. Names that an animation lacks are ignored, so
// that a scene can be reloaded without its parameter.
struct Overrides {
    std::map<std::string, double> values;  // of tracks: "m", "blobs.sharpness"
    std::map<std::string, double> factors; // of element fields: "blobs.cx"

    bool empty() const { return values.empty() && factors.empty(); }
    bool operator==(const Overrides&) const = default;
};

// With several surfaces, names begin with the surface's name: "NAME/m". of_surface() returns those
// of one surface without that prefix; put_surface() replaces them by `own`. The only surface of a
// scene has all, and no prefix.
Overrides of_surface(const Overrides& all, const scene::OneSurface& one);
void put_surface(Overrides& all, const scene::OneSurface& one, const Overrides& own);

// Fixes the tracks and multiplies the fields. Throws animation::ExpressionError for a number that
// is not finite.
animation::Animation apply(const animation::Animation& animation, const Overrides& overrides);
scene::Scene apply(scene::Scene scene, const Overrides& overrides);

// The range of a slider. It is computed once per surface, since that evaluates the whole timeline.
struct SliderRange {
    std::string name;
    int track = 0; // of the animation
    double least = 0, most = 1;
    bool moves = false; // the scene animates it: keys, or values that differ from frame to frame
};
// One for each parameter, then one for each field that all elements share. A range holds every
// value in the timeline (sampled) and the catalogue's range. If there are only equal values and no
// such range, it is [0, 2v], or [-1, 1] for v = 0.
std::vector<SliderRange> slider_ranges(const scene::OneSurface& one);

struct Slider {
    std::string name;
    double value = 0; // current value, overridden or not
    double least = 0, most = 1;
    bool moves = false;
    bool overridden = false;
};
// `values`: of the animation with the overrides.
std::vector<Slider> sliders(const std::vector<SliderRange>& ranges, const animation::Values& values,
                            const Overrides& overrides);

// An array: the current number of its elements, and a factor from 0 to 4 for each of its own
// fields, 1 unless overridden.
struct ArrayControls {
    std::string name;
    int count = 0;
    std::vector<Slider> factors; // named "blobs.cx"
};
std::vector<ArrayControls> array_controls(const animation::Animation& animation,
                                          const animation::Values& values,
                                          const Overrides& overrides);

} // namespace isomotion::player
