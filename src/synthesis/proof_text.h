// Shaders that prove where rays ended, see render/proofs.h and shaders/proof/.
#pragma once

#include <string>
#include <vector>

#include "synthesis/assemble.h"

namespace isomotion::synthesis {

// How F is bounded at a point that float32 leaves uncertain: over the box of all that it can be, or
// by its gradient there, which is closer and costs more; or that in doubles, where float32 cancels.
enum class ProofBounds { natural, by_gradient, in_doubles };

// What a piece of a proof asks of the field.
std::vector<FieldFunction> proof_samples(const formula::Field& field, ProofBounds bounds);

// One pass of proofs. Adds to `shaders.files`; its beams must be there.
std::string proof_text(const scene::Scene& scene, Shaders& shaders, ProofBounds bounds);

std::string unfinished_proofs_text(std::vector<std::string>& files);

} // namespace isomotion::synthesis
