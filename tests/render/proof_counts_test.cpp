#include "render/proof_outcome.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isomotion::render::proof_counts_test {
namespace {

TEST(ProofCounts, CountFirstNumbersAlone) {
    constexpr unsigned seed = 7;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const std::size_t pixels : {0u, 1u, 4095u, 4096u, 4097u, 20'001u}) {
        std::vector<float> record(4 * pixels, 2.0f);
        ProofCounts expected{};
        for (std::size_t k = 0; k < pixels; ++k) {
            const std::size_t proof = random() % proof_names.size();
            record[4 * k] = float(proof);
            ++expected[proof];
        }
        EXPECT_EQ(count_proofs(record), expected) << pixels;
    }
}

TEST(ProofCounts, TakeWhatIsNoOutcomeForNotLookedAt) {
    const std::vector<float> record{1, 0, 0, 0, -3, 0, 0, 0, NAN, 0, 0, 0, 2.5f, 0, 0, 0};
    const ProofCounts counts = count_proofs(record);
    EXPECT_EQ(counts[std::size_t(Proof::hit)], 1);
    EXPECT_EQ(counts[std::size_t(Proof::none)], 3);
    EXPECT_EQ(proved_part(counts), 0.25);
}

} // namespace
} // namespace isomotion::render::proof_counts_test
