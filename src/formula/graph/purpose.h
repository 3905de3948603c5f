// Why an expression is kept in range, see in_range.h.
#pragma once

namespace isomotion::formula {

enum class Purpose {
    numbers, // values and, differentiated, slopes at points
    bounds,  // values over boxes
    slopes,  // difference quotients over boxes
};

} // namespace isomotion::formula
