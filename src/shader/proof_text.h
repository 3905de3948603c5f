// Shaders that prove the ends of rays, see render/proofs.h and shaders/proof/.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"
#include "shader/pass.h"

namespace isomotion::shader {

// How F is bounded at a point that float32 leaves uncertain: over the box of all possible places;
// or by its gradient there, which is tighter and costs more; or the latter in doubles, where
// float32 cancels.
enum class ProofBounds { natural, by_gradient, in_doubles };

// Pixels across the blocks whose rays are proved together.
inline constexpr int proved_block = 4;
// The same for larger blocks, for which the part before all roots is proved first, if models exist.
inline constexpr int coarse_proved_block = 16;
// Texels in a row of the list of open blocks or rays: shaders/proof/packed.glsl.
inline constexpr int open_list_across = 1024;

// The cost of a piece of a block's proof, and of a single ray's.
formula::Cost cost_of_block_piece(const formula::Field& field, const FieldStorage& storage,
                                  std::span<const int> counts);
formula::Cost cost_of_piece(const formula::Field& field, const FieldStorage& storage,
                            ProofBounds bounds, std::span<const int> counts);

// All passes of proofs; `plan` must have its beams.
std::vector<Pass> proof_passes(const scene::OneSurface& one, const PassPlan& plan);

} // namespace isomotion::shader
