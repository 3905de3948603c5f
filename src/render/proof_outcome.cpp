#include "render/proof_outcome.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace isomotion::render {

// Lanes of ints, which loops vectorise; few enough at a time that these hold the counts.
ProofCounts count_proofs(std::span<const float> record) {
    constexpr std::size_t at_a_time = 4 * 4096;
    ProofCounts counts{};
    for (std::size_t begin = 0; begin < record.size(); begin += at_a_time) {
        const auto part = record.subspan(begin, std::min(at_a_time, record.size() - begin));
        std::array<int, proof_names.size()> of_part{};
        for (std::size_t k = 0; k < part.size(); k += 4) {
            for (std::size_t proof = 0; proof < of_part.size(); ++proof)
                of_part[proof] += part[k] == float(proof);
        }
        for (std::size_t proof = 0; proof < counts.size(); ++proof) counts[proof] += of_part[proof];
    }
    // What is no outcome proves nothing.
    const auto counted = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    counts[std::size_t(Proof::none)] += std::int64_t(record.size() / 4) - counted;
    return counts;
}

double proved_part(const ProofCounts& counts) {
    const auto all = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    const auto proved = counts[std::size_t(Proof::hit)] + counts[std::size_t(Proof::miss)];
    return all > 0 ? double(proved) / double(all) : 0;
}

std::string summary(const ProofCounts& counts) {
    const auto all = double(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
    std::string text = fmt::format("proved {:.2f} %", 100 * proved_part(counts));
    const char* before = "; not proved: ";
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (is_proved(Proof(k)) || counts[k] == 0) continue;
        text += fmt::format("{}{:.2f} % {}", before, 100 * double(counts[k]) / all, proof_names[k]);
        before = ", ";
    }
    return text;
}

} // namespace isomotion::render
