// A scene's parameters under a person's control: sliders, and the animation they lead to.
//
// An override fixes a track at a number in place of its keys or expression, as if the scene file
// said so: expressions that name the track follow. Fields of an array's elements are multiplied as
// a whole. apply() makes a new animation; formula and shaders stay.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::player {

// Values that a person set in place of the scene's. Names that an animation lacks are ignored, so
// that a scene may be reloaded without its parameter.
struct Overrides {
    std::map<std::string, double> values;  // of tracks: "m", "blobs.sharpness"
    std::map<std::string, double> factors; // of element fields: "blobs.cx"

    bool empty() const { return values.empty() && factors.empty(); }
    bool operator==(const Overrides&) const = default;
};

// Where a scene has several surfaces, names begin with the surface's: "NAME/m". of_surface() gives
// those of one surface without its name, put_surface() puts `own` in their place.
Overrides of_surface(const Overrides& all, const std::string& surface);
void put_surface(Overrides& all, const std::string& surface, const Overrides& own);

// Fixes the tracks and multiplies the fields. Throws animation::ExpressionError for a number that
// is not finite.
animation::Animation apply(const animation::Animation& animation, const Overrides& overrides);
scene::Scene apply(scene::Scene scene, const Overrides& overrides);

// The range of a slider: found once per scene, since it takes the whole timeline.
struct SliderRange {
    std::string name;
    int track = 0; // of the animation
    double least = 0, most = 1;
    bool moves = false; // the scene moves it: keys, or values that differ from frame to frame
};
// One for each parameter, then for each field that all elements share. A range holds every value
// that the timeline takes (sampled) and the catalogue's range; where these say nothing it is
// [0, 2v], or [-1, 1] about 0.
std::vector<SliderRange> slider_ranges(const scene::Scene& scene);

struct Slider {
    std::string name;
    double value = 0; // now, overridden or not
    double least = 0, most = 1;
    bool moves = false;
    bool overridden = false;
};
// `values`: of the animation with the overrides.
std::vector<Slider> sliders(const std::vector<SliderRange>& ranges, const animation::Values& values,
                            const Overrides& overrides);

// An array: the number of its elements now, and a factor from 0 to 4 for each of its own fields, 1
// unless overridden.
struct ArrayControls {
    std::string name;
    int count = 0;
    std::vector<Slider> factors; // named "blobs.cx"
};
std::vector<ArrayControls> array_controls(const scene::Scene& scene,
                                          const animation::Values& values,
                                          const Overrides& overrides);

} // namespace isomotion::player
