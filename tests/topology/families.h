// Scenes drawn at random: sums over elements that move along straight paths, on circles or as keys
// tell, with sizes, levels and factors that move too, in boxes and balls.
#pragma once

#include <string>

namespace isomotion::topology {

struct FamilyDraw {
    std::string name; // what was drawn, for a person
    std::string text; // a scene file
};

// The same for the same seed, on every machine. Elements in all arrays together: from `fewest` to
// `most`, few more often than many.
FamilyDraw draw_family(unsigned seed, int fewest, int most);

} // namespace isomotion::topology
