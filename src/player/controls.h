// A scene's parameters in the hand: sliders, and what they make of the animation.
//
// A track that is touched is released from its keys or expression and has the number it was given,
// as if the scene file had said so: whatever names it follows. Given back, it moves again. Fields
// of an array's elements are multiplied as a whole. The animation with what is released is a new
// one; formula and shaders don't change.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::player {

// What a person holds. Names that an animation does not have mean nothing, so that a scene may be
// reloaded without its parameter. Erasing a name gives it back.
struct Released {
    std::map<std::string, double> values;  // of tracks: "m", "blobs.sharpness"
    std::map<std::string, double> factors; // of element fields: "blobs.cx"

    bool empty() const { return values.empty() && factors.empty(); }
    bool operator==(const Released&) const = default;
};

// The animation with these tracks fixed and these fields multiplied.
// Throws animation::ExpressionError for a number that is not finite.
animation::Animation apply(const animation::Animation& animation, const Released& released);
// The same scene moving so.
scene::Scene apply(scene::Scene scene, const Released& released);

// What a slider spans: found once a scene, as it looks at the whole timeline.
struct Span {
    std::string name;
    int track = 0; // of the animation
    double least = 0, most = 1;
    bool moves = false; // the scene moves it: keys, or values that differ from frame to frame
};
// Of the parameters, then of fields that all elements share. A span holds every value the timeline
// takes (sampled) and the catalogue's range; a side that neither tells is as far as the value is
// large: [0, 2v], or [-1, 1] about 0.
std::vector<Span> spans(const scene::Scene& scene);

struct Slider {
    std::string name;
    double value = 0; // now, released or not
    double least = 0, most = 1;
    bool moves = false;
    bool released = false;
};
// `values` are those of the animation with what is released.
std::vector<Slider> sliders(const std::vector<Span>& spans, const animation::Values& values,
                            const Released& released);

// An array: how many elements there are now, and a factor for each of its own fields, 1 unless
// released, from 0 to 4.
struct ArrayControls {
    std::string name;
    int count = 0;
    std::vector<Slider> factors; // named "blobs.cx"
};
std::vector<ArrayControls> array_controls(const scene::Scene& scene,
                                          const animation::Values& values,
                                          const Released& released);

} // namespace isomotion::player
