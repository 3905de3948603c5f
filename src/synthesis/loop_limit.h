// How long the loops of a shader may be.
#pragma once

namespace isomotion::synthesis {

// Loop iterations a shader may do in all; below the driver's 65535, which ends loops silently, by
// what the march itself loops.
inline constexpr double loop_iterations_per_pass = 60'000;

// Cells of a grid of elements that a box may meet and have bounds.
inline constexpr int most_cells_of_box = 12;

} // namespace isomotion::synthesis
