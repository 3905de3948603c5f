// Pictures that vouch for themselves: some rays of each, drawn at random, are held against
// certified truth. An audit changes no pixel.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/scene.h"
#include "truth/field_at_frame.h"
#include "truth/judge.h"

namespace isomotion::audit {

struct WrongPixel {
    int frame = 0, column = 0, row = 0; // from the top
    truth::Fault fault = truth::Fault::none;
};

struct Findings {
    std::int64_t rays = 0;      // of which truth is certain
    std::int64_t undecided = 0; // also those that touch the surface, which may be drawn either way
    std::int64_t wrong = 0;     // of `rays`
    std::vector<WrongPixel> examples{}; // some of the wrong ones

    void add(const Findings& other);
};

// With so many rays right and none wrong, the part of all rays that is wrong is, 95 % sure, at most
// this: the part p of which (1 - p)^rays is 5 %.
double most_wrong(std::int64_t rays);

// "audited 30,720 rays of 120 frames: none wrong (at most 98 in a million, 95 % sure)"
std::string words(const Findings& findings, int frames);

// `count` different pixels, ascending, by the frame's number alone.
std::vector<int> pixels_of_frame(int width, int height, int count, int frame);

// Holds rays of one scene against truth, a frame after the other. One a thread.
class Auditor {
public:
    explicit Auditor(const scene::Scene& scene); // which outlives it

    // Compares rays of a picture of frame `frame` of the given size and aim; fewer where it is to
    // stop. `grid`: of the first surface's elements then, if the picture was drawn by one.
    Findings hold(int frame, const scene::SceneAt& now, const scene::Aim& aim, int width,
                  int height, std::span<const render::Ending> endings,
                  const std::function<bool()>& stop = {},
                  std::shared_ptr<const elements::ElementGrid> grid = nullptr);

    // Operations of the formula; of elements that are found by place about as many as matter at
    // one.
    double operations_at_a_point() const;

    // What a ray has taken so far, in the mean; 0 before the first.
    double seconds_a_ray() const { return rays_ > 0 ? seconds_ / double(rays_) : 0; }

private:
    const scene::Scene& scene_;
    std::vector<truth::EnclosedField> fields_; // of each surface
    double seconds_ = 0;
    std::int64_t rays_ = 0;
};

// How many rays to hold of a frame: as many as a part of its drawing pays for, and 64 at least, but
// for formulas of so many operations at a point that these would take seconds.
int affordable(double drawing_seconds, double seconds_a_ray, double operations);

} // namespace isomotion::audit
