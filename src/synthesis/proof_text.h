// Shaders that prove where rays ended, see render/proofs.h and shaders/proof/.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "synthesis/pass.h"

namespace isomotion::synthesis {

// How F is bounded at a point that float32 leaves uncertain: over the box of all that it can be, or
// by its gradient there, which is closer and costs more; or that in doubles, where float32 cancels.
enum class ProofBounds { natural, by_gradient, in_doubles };

// Pixels across the blocks whose rays are proved together.
inline constexpr int proved_block = 4;

// What proofs ask of the field: those of blocks, and a piece of those of single rays.
std::vector<FieldFunction> block_proof_samples();
std::vector<FieldFunction> proof_samples(const formula::Field& field, const FieldStorage& storage,
                                         ProofBounds bounds);

// All passes of proofs; the beams of `passes` must be there.
std::vector<Pass> proof_passes(const scene::Scene& scene, const Passes& passes);

} // namespace isomotion::synthesis
