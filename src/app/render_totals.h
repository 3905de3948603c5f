// What a run of `render` did, over all frames, and how it tells.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "sequence/standing.h"

namespace isomotion::app {

struct RenderTotals {
    std::array<std::int64_t, render::verdict_names.size()> verdicts{};
    render::ProofCounts proofs{};
    std::int64_t evaluations = 0;
    std::chrono::duration<double> drawing{};
    int drawn = 0, reused = 0;
    std::map<sequence::Standing, std::vector<int>> found; // of --resume: how frames stood before

    void add(const render::Picture& picture);
    void note(int frame, sequence::Standing standing) { found[standing].push_back(frame); }

    // `wall`: how long all of it took. Lines that end with a newline each.
    std::string summary(std::chrono::duration<double> wall) const;
};

} // namespace isomotion::app
