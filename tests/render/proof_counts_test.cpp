#include "render/proofs.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isomotion::render {
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

} // namespace
} // namespace isomotion::render
