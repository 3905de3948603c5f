// Statistics of rays for the public header, and those of pictures again.
#pragma once

#include <array>
#include <chrono>

#include "isomotion/drawing.h"
#include "render/proof_outcome.h"
#include "render/ray_counts.h"
#include "render/record.h"

namespace isomotion::api {

using Verdicts = std::array<std::int64_t, render::verdict_names.size()>;

RayStatistics statistics_of(const Verdicts& verdicts, const render::RayCounts& rays,
                            const render::ProofCounts& proofs,
                            std::chrono::duration<double> drawing);

Verdicts verdicts_of(const RayStatistics& statistics);
render::RayCounts rays_of(const RayStatistics& statistics);
render::ProofCounts proofs_of(const RayStatistics& statistics); // all 0 where nothing was proved

} // namespace isomotion::api
