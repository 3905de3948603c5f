// The frame exactly at a change of topology, and the parameter one float before and after it.
#include "stability/hard_case.h"

#include <cmath>

#include <fmt/format.h>

namespace isomotion::stability {
namespace {

using scene::Method;

struct Change {
    std::string surface, parameter;
    double critical;
    double wrong_ppm; // of the sign test
};
void PrintTo(const Change& change, std::ostream* out) {
    *out << change.surface << " " << change.parameter << " = " << change.critical;
}

class CriticalTime : public testing::TestWithParam<Change> {};

TEST_P(CriticalTime, AndOneFloatBeforeAndAfter) {
    const Change& change = GetParam();
    const float at = float(change.critical);
    std::vector<std::vector<float>> verdicts;
    for (const auto& [when, value] : {std::pair{"before", std::nextafter(at, -INFINITY)},
                                      {"at", at},
                                      {"after", std::nextafter(at, INFINITY)}}) {
        const HardCase a_case{
            fmt::format("{} {} {} = {}", change.surface, when, change.parameter, change.critical),
            surface(change.surface,
                    fmt::format("[parameters]\n{} = {:.17g}\n", change.parameter, double(value))),
            {}};
        SCOPED_TRACE(when);
        expect_bounds(a_case); // by default
        const Looked looked = look(a_case, Method::amp_sign);
        EXPECT_GT(looked.hits, 300);
        EXPECT_LE(looked.errors.wrong_ppm(), change.wrong_ppm);
        EXPECT_EQ(looked.errors.nan, 0);
        EXPECT_EQ(looked.errors.step_limit, 0);
        EXPECT_EQ(looked.crooked, 0);
        verdicts.push_back(looked.picture.frame.find("verdict")->samples);
    }
    // A float's difference moves no pixel but ones that graze.
    for (const std::size_t other : {0u, 2u}) {
        int different = 0;
        for (std::size_t k = 0; k < verdicts[1].size(); ++k) {
            different += verdicts[1][k] != verdicts[other][k];
        }
        EXPECT_LE(different, 4);
    }
}

INSTANTIATE_TEST_SUITE_P(Stability, CriticalTime,
                         testing::Values(Change{"barth_sextic", "alpha", 1, 520},
                                         Change{"barth_decic", "alpha", 1, 1900},
                                         Change{"steiner", "c", 0, 1100},
                                         Change{"cassini", "a", 1, 0}, Change{"torus", "c", 0.4, 0},
                                         Change{"chmutov_8", "c", 1, 650},
                                         Change{"chmutov_12", "c", -1, 0},
                                         Change{"kummer", "c", 0, 0}, Change{"cayley", "c", 0, 390},
                                         Change{"tangle", "c", 12.5, 0}),
                         [](const auto& tested) {
                             return tested.param.surface +
                                    (tested.param.critical < 0 ? "_minus" : "") + "_" +
                                    tested.param.parameter;
                         });

} // namespace
} // namespace isomotion::stability
