// Audits pictures: compares some of their rays, drawn at random, with certified truth. An audit
// changes no pixel.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "roots/field_at_frame.h"
#include "roots/judge.h"
#include "scene/scene.h"

namespace isomotion::audit {

struct WrongPixel {
    int frame = 0, column = 0, row = 0; // from the top
    roots::Fault fault = roots::Fault::none;
};

struct Findings {
    std::int64_t rays = 0; // for which truth is certain
    // Includes rays that touch the surface, which may be drawn either way.
    std::int64_t undecided = 0;
    std::int64_t wrong = 0;             // among `rays`
    std::vector<WrongPixel> examples{}; // some of the wrong ones

    void add(const Findings& other);
};

// With so many rays right and none wrong, this bounds the part of all rays that is wrong, with 95 %
// confidence: the part p with (1 - p)^rays = 5 %.
double most_wrong(std::int64_t rays);

// "audited 30,720 rays of 120 frames: none wrong (at most 98 in a million, 95 % sure)"
std::string words(const Findings& findings, int frames);

// `count` different pixels, ascending; they depend on the frame's number alone.
std::vector<int> pixels_of_frame(int width, int height, int count, int frame);

// Compares rays of one scene with truth, frame by frame. Use one per thread.
class Auditor {
public:
    explicit Auditor(const scene::Scene& scene); // must outlive this object

    // Compares rays of a picture of frame `frame` with the given size and aim; fewer if `stop`
    // returns true. `grid`: the grid of the first surface's elements, if the picture was drawn with
    // one.
    Findings hold(int frame, const scene::SceneAt& now, const scene::Aim& aim, int width,
                  int height, std::span<const render::Ending> endings,
                  const std::function<bool()>& stop = {},
                  std::shared_ptr<const elements::ElementGrid> grid = nullptr);

    // Operations of the formula. If elements are found by place, this counts about as many as
    // matter at a place.
    double operations_at_a_point() const;

    // Mean time of a ray so far; 0 before the first.
    double seconds_a_ray() const { return rays_ > 0 ? seconds_ / double(rays_) : 0; }

private:
    const scene::Scene& scene_;
    std::vector<roots::EnclosedField> fields_; // for each surface
    double seconds_ = 0;
    std::int64_t rays_ = 0;
};

// The number of rays to compare in a frame: as many as a part of its drawing time allows, but at
// least 64, unless the formula has so many operations at a point that 64 would take seconds.
int affordable(double drawing_seconds, double seconds_a_ray, double operations);

} // namespace isomotion::audit
