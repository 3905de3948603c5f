#include "formula/graph/vocabulary.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include "formula/graph/limits.h"

namespace isomotion::formula {
namespace {

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

bool is_identifier(std::string_view name) {
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) return false;
    return std::all_of(name.begin(), name.end(),
                       [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates) {
    std::string best;
    if (word.size() > limits::name_bytes) return best; // no slip of the finger
    int best_distance = std::max(1, int(word.size()) / 3) + 1;
    for (const std::string& candidate : candidates) {
        // For one-letter names every other letter is one edit away: no suggestion is better.
        if (word.size() == 1 && candidate.size() == 1) continue;
        if (candidate.size() > 2 * limits::name_bytes) continue;
        const int distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

} // namespace isomotion::formula
