// Compares a drawn picture with the truth, pixel by pixel.
//
// A pixel is wrong only if it is wrong for every ray that float32 may compute for it. A pixel that
// truth calls touching may be hit or not. Pixels that truth leaves undecided are excluded.
#pragma once

#include <cstdint>
#include <vector>

#include "render/renderer.h"
#include "roots/certify.h"
#include "roots/judge.h"
#include "scene/scene.h"

namespace isomotion::accuracy {

using roots::Fault;

struct Errors {
    std::vector<Fault> faults;         // rows from the top
    std::int64_t pixels = 0, rays = 0; // rays: pixels that meet the bounds
    std::int64_t missed = 0, false_hits = 0, wrong_roots = 0, undecided = 0;
    std::int64_t nan = 0, step_limit = 0;
    // For pictures with the channel proof: the outcomes, and the number of proofs that truth
    // certainly contradicts, which shows a bug in one of the two.
    render::ProofCounts proofs{};
    std::int64_t contradicted = 0;
    // Errors of hits on the certified root, sorted: distance along the ray in widths of the pixel,
    // angle of the normal in degrees.
    std::vector<float> depth, normal;

    std::int64_t wrong() const { return missed + false_hits + wrong_roots; }
    double wrong_ppm() const { return 1e6 * double(wrong()) / double(pixels); }
    void add(const Errors& other); // everything except the faults
};

// 0 for no values; `part` 0.5 is the median, 1 the largest.
double quantile(const std::vector<float>& sorted, double part);

// The picture must have the channels position, normal and verdict.
Errors compare(const scene::SceneAt& now, const image::Frame& drawn, const roots::Truth& truth);

} // namespace isomotion::accuracy
