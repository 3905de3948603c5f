// How much of what could be tried a test tries. `tools/test` tries each value at least once; what
// is THOROUGH in CMakeLists.txt has an entry of `tools/test --all` besides, which tries every
// combination of them.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace isomotion {

// Whether the environment has ISOMOTION_THOROUGH=1.
bool is_thorough();

// A number of random trials.
inline int trials(int quick, int thorough) { return is_thorough() ? thorough : quick; }

// All pairs, or as few as have each of `a` and each of `b`: the k-th of one with the k-th of the
// other, where the shorter list begins again.
template<typename A, typename B>
std::vector<std::pair<A, B>> pairs_of(const std::vector<A>& a, const std::vector<B>& b) {
    std::vector<std::pair<A, B>> pairs;
    if (is_thorough()) {
        for (const A& first : a)
            for (const B& second : b) pairs.emplace_back(first, second);
    } else if (!a.empty() && !b.empty()) {
        for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k)
            pairs.emplace_back(a[k % a.size()], b[k % b.size()]);
    }
    return pairs;
}

} // namespace isomotion
