// Matches the items of two lists at the least cost.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace isomotion::topology {

// Finds for each of `rows` its column, or nothing: the assignment with the least sum of costs,
// where an unmatched item costs `alone`. Costs are not negative; pairs that cost 2 * alone or more
// are never made. The method is shortest augmenting paths (Kuhn 1955; Jonker and Volgenant 1987),
// which takes a time of min^2 max of the two lists' lengths.
std::vector<std::optional<std::size_t>>
match(std::size_t rows, std::size_t columns,
      const std::function<double(std::size_t row, std::size_t column)>& cost, double alone);

} // namespace isomotion::topology
