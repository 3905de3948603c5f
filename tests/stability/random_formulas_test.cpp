// The method that nobody had to choose on random formulas of every class: tests/bench/random draws
// many more.
#include "scenes/hard_case.h"

#include <cstdlib>

#include "random/families.h"

namespace isomotion::stability {
namespace {

class RandomFormulas : public testing::TestWithParam<bench::Family> {};

void are_drawn_right_by_default(const bench::Family& family, std::uint64_t from, std::uint64_t to) {
    const char* const wanted = std::getenv("ISOMOTION_SEED");
    const std::uint64_t seed = wanted ? std::strtoull(wanted, nullptr, 10) : 4'000'000;
    // Beside cuspidal edges float32 has lost F, which is the difference of a square and a cube.
    const int beside_edges = family.name == "polynomial" ? 4 : 0;
    for (std::uint64_t k = from; k < to; ++k) {
        SCOPED_TRACE(testing::Message() << "seed " << seed + k << " (ISOMOTION_SEED)");
        const HardCase drawn{fmt::format("random: {}", family.name),
                             bench::random_scene(family, seed + k, 64),
                             {},
                             {},
                             0,
                             false,
                             /*is_drawn_by_chance=*/true};
        const Looked looked = look(drawn, scene::Method::hermite);
        EXPECT_LE(looked.errors.wrong(), beside_edges)
            << drawn.scene << '\n'
            << wrong_pixels(looked) << "drawn once more:\n"
            << wrong_pixels(look(drawn, scene::Method::hermite));
        EXPECT_EQ(looked.errors.nan + looked.errors.step_limit, 0) << drawn.scene;
        EXPECT_EQ(looked.crooked, 0) << drawn.scene;
    }
}

TEST_P(RandomFormulas, AreDrawnRightByDefault) { are_drawn_right_by_default(GetParam(), 0, 1); }
TEST_P(RandomFormulas, MoreAreDrawnRightByDefault) { are_drawn_right_by_default(GetParam(), 1, 8); }

INSTANTIATE_TEST_SUITE_P(Stability, RandomFormulas,
                         testing::ValuesIn(bench::families().begin(), bench::families().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace isomotion::stability
