#include "topology/timeline/matching.h"

#include <algorithm>
#include <limits>

namespace isomotion::topology {

std::vector<std::optional<std::size_t>>
match(std::size_t rows, std::size_t columns,
      const std::function<double(std::size_t row, std::size_t column)>& cost, double alone) {
    std::vector<std::optional<std::size_t>> found(rows);
    if (rows > columns) {
        const auto other = match(
            columns, rows, [&](std::size_t c, std::size_t r) { return cost(r, c); }, alone);
        for (std::size_t c = 0; c < columns; ++c) {
            if (other[c]) found[*other[c]] = c;
        }
        return found;
    }
    // Every row gets a column; a pair that costs as much as two items alone stands for that. Row
    // and column 0 are where paths begin; potentials keep reduced costs from being negative.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> row_potential(rows + 1, 0), column_potential(columns + 1, 0);
    std::vector<std::size_t> row_of(columns + 1, 0), previous(columns + 1, 0);
    std::vector<double> shortest(columns + 1);
    std::vector<char> reached(columns + 1);
    std::vector<double> costs; // asked for once each: a row is gone over for many others
    costs.reserve(rows * columns);
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            costs.push_back(std::min(cost(r, c), 2 * alone));
        }
    }
    const auto cost_of = [&](std::size_t row, std::size_t column) {
        return costs[(row - 1) * columns + column - 1];
    };
    for (std::size_t row = 1; row <= rows; ++row) {
        std::ranges::fill(shortest, infinity);
        std::ranges::fill(reached, 0);
        row_of[0] = row;
        std::size_t column = 0;
        do {
            reached[column] = 1;
            const std::size_t r = row_of[column];
            std::size_t nearest = 0;
            double step = infinity;
            for (std::size_t c = 1; c <= columns; ++c) {
                if (reached[c]) continue;
                const double reduced = cost_of(r, c) - row_potential[r] - column_potential[c];
                if (reduced < shortest[c]) {
                    shortest[c] = reduced;
                    previous[c] = column;
                }
                if (shortest[c] < step) {
                    step = shortest[c];
                    nearest = c;
                }
            }
            for (std::size_t c = 0; c <= columns; ++c) {
                if (reached[c]) {
                    row_potential[row_of[c]] += step;
                    column_potential[c] -= step;
                } else {
                    shortest[c] -= step;
                }
            }
            column = nearest;
        } while (row_of[column] != 0);
        for (; column != 0; column = previous[column]) row_of[column] = row_of[previous[column]];
    }
    for (std::size_t c = 1; c <= columns; ++c) {
        if (const std::size_t r = row_of[c]; r != 0 && cost_of(r, c) < 2 * alone) {
            found[r - 1] = c - 1;
        }
    }
    return found;
}

} // namespace isomotion::topology
