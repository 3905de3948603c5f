#include "api/drawing/statistics.h"

#include <algorithm>
#include <numeric>

namespace isomotion {
namespace api {
namespace {

// Where the statistics hold the rays of each verdict.
constexpr std::array<std::int64_t RayStatistics::*, render::verdict_names.size()> of_verdicts{
    &RayStatistics::misses, &RayStatistics::hits, &RayStatistics::step_limits,
    &RayStatistics::not_numbers, &RayStatistics::zero_gradients};

} // namespace

RayStatistics statistics_of(const Verdicts& verdicts, const render::RayCounts& rays,
                            const render::ProofCounts& proofs,
                            std::chrono::duration<double> drawing) {
    RayStatistics statistics;
    for (std::size_t v = 0; v < verdicts.size(); ++v) statistics.*of_verdicts[v] = verdicts[v];
    for (std::size_t k = 0; k < rays.size(); ++k) {
        statistics.kinds.push_back({std::string(render::ray_kind_names[k]), rays[k].evaluations,
                                    rays[k].most, rays[k].undecided});
    }
    const bool certified = std::ranges::any_of(proofs, [](auto pixels) { return pixels > 0; });
    for (std::size_t p = 0; certified && p < proofs.size(); ++p) {
        statistics.proofs.push_back(
            {std::string(render::proof_names[p]), render::is_proved(render::Proof(p)), proofs[p]});
    }
    statistics.seconds = drawing.count();
    return statistics;
}

Verdicts verdicts_of(const RayStatistics& statistics) {
    Verdicts verdicts{};
    for (std::size_t v = 0; v < verdicts.size(); ++v) verdicts[v] = statistics.*of_verdicts[v];
    return verdicts;
}

render::RayCounts rays_of(const RayStatistics& statistics) {
    render::RayCounts rays{};
    for (std::size_t k = 0; k < std::min(rays.size(), statistics.kinds.size()); ++k) {
        const RayStatistics::Kind& kind = statistics.kinds[k];
        rays[k] = {.evaluations = kind.evaluations, .most = kind.most, .undecided = kind.undecided};
    }
    return rays;
}

render::ProofCounts proofs_of(const RayStatistics& statistics) {
    render::ProofCounts proofs{};
    for (std::size_t p = 0; p < std::min(proofs.size(), statistics.proofs.size()); ++p)
        proofs[p] = statistics.proofs[p].pixels;
    return proofs;
}

} // namespace api

std::int64_t RayStatistics::rays() const {
    const api::Verdicts verdicts = api::verdicts_of(*this);
    return std::accumulate(verdicts.begin(), verdicts.end(), std::int64_t(0));
}

std::int64_t RayStatistics::evaluations() const { return render::evaluations(api::rays_of(*this)); }

} // namespace isomotion
