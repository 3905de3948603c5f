#include "base/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace isomotion::base {
namespace {

constexpr std::size_t longest_slip = 64; // what is longer is no slip of the finger

// Insertions, deletions, substitutions and swaps of neighbours, letter case ignored.
int edit_distance(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    const auto same = [&](std::size_t i, std::size_t j) { return lower(a[i]) == lower(b[j]); };
    std::vector<int> before, last, row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        before = std::exchange(last, row);
        row[0] = int(i) + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const int substitute = last[j] + (same(i, j) ? 0 : 1);
            row[j + 1] = std::min({substitute, row[j] + 1, last[j + 1] + 1});
            if (i > 0 && j > 0 && same(i, j - 1) && same(i - 1, j)) {
                row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
            }
        }
    }
    return row.back();
}

} // namespace

std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates) {
    std::string best;
    if (word.size() > longest_slip) return best;
    int best_distance = std::max(1, int(word.size()) / 3) + 1;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > 2 * longest_slip) continue;
        const int distance = edit_distance(word, candidate);
        // For one-letter names every other letter is one edit away: no suggestion is better.
        if (word.size() == 1 && candidate.size() == 1 && distance > 0) continue;
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

} // namespace isomotion::base
