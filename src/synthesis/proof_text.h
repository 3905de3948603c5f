// Shaders that prove where rays ended, see render/proofs.h and shaders/proof/.
#pragma once

#include <string>
#include <vector>

#include "synthesis/assemble.h"

namespace isomotion::synthesis {

// What a piece of a proof asks of the field.
inline const std::vector<FieldFunction> proof_samples{FieldFunction::value_interval,
                                                      FieldFunction::along_interval};

// One pass of proofs. Adds to `shaders.files`; its beams must be there.
std::string proof_text(const scene::Scene& scene, Shaders& shaders);

std::string unfinished_proofs_text(std::vector<std::string>& files);

} // namespace isomotion::synthesis
