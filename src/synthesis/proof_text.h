// Shaders that prove where rays ended, see render/proofs.h and shaders/proof/.
#pragma once

#include <string>
#include <vector>

#include "synthesis/assemble.h"

namespace isomotion::synthesis {

// How F is bounded at a point that float32 leaves uncertain: over the box of all that it can be, or
// by its gradient there, which is closer and costs more; or that in doubles, where float32 cancels.
enum class ProofBounds { natural, by_gradient, in_doubles };

// Pixels across the blocks whose rays are proved together.
inline constexpr int proved_block = 4;

// Proves blocks of rays; and what begins the proof of each ray.
std::vector<FieldFunction> block_proof_samples();
std::string block_proof_text(const scene::Scene& scene, Shaders& shaders);
std::string begin_proof_text(const scene::Scene& scene, Shaders& shaders);

// What a piece of a proof asks of the field.
std::vector<FieldFunction> proof_samples(const formula::Field& field, ProofBounds bounds);

// One pass of proofs. Adds to `shaders.files`; its beams must be there.
std::string proof_text(const scene::Scene& scene, Shaders& shaders, ProofBounds bounds);

// Which rays have something to prove; and which no longer.
std::string to_prove_text(const scene::Scene& scene, Shaders& shaders);
std::string close_proofs_text(std::vector<std::string>& files);
// Copies proofs.
std::string keep_text(std::vector<std::string>& files);

} // namespace isomotion::synthesis
