// Whole timelines of solids with kinks: by hand, and at random against signs on grids.
#include <random>

#include <gtest/gtest.h>

#include "topology/betti/frame_signs.h"
#include "topology/solids.h"
#include "topology/timeline/steps.h"
#include "topology/told.h"

namespace isomotion::topology {
namespace {

const std::string around = "{ box = [[-2.1, -2.2, -2.3], [2.4, 2.5, 2.2]] }";
void expect_around(const std::string& formula, const std::string& parameters, const Betti& start,
                   const std::vector<Told>& told, const Betti& end) {
    expect_timeline({formula, around, parameters, in_a_second}, start, told, end);
}

TEST(KinkedTimelines, AreThoseMadeByHand) {
    const Betti ball{1, 0, 0};
    expect_around("min((x - s)^2 + y^2 + z^2 - 0.25, (x + s)^2 + y^2 + z^2 - 0.25)",
                  "s = \"0.8 - 0.6*t\"", {2, 0, 0}, {{0.5, Kind::merge}}, ball);
    expect_around("max(x^2 + y^2 + z^2 - 1, 0.25 - (x - s)^2 - y^2 - z^2)", "s = \"t - 0.25\"",
                  {1, 0, 1}, {{0.75, Kind::void_opens}}, ball);
    expect_around("(sqrt(x^2 + y^2) - R)^2 + z^2 - 0.09", "R = \"0.2 + 0.6*t\"", ball,
                  {{1.0 / 6, Kind::tunnel_opens}}, {1, 1, 0});
    // Two drills through a cube at right angles: two tunnels, three where they meet.
    expect_around("max(max(max(abs(x), abs(y)), abs(z)) - 1, "
                  "max(0.0625 - x^2 - (y - s)^2, 0.0625 - (y + s)^2 - z^2))",
                  "s = \"0.5 - t\"", {1, 2, 0},
                  {{0.25, Kind::tunnel_opens}, {0.75, Kind::tunnel_closes}}, {1, 2, 0});
    // Two balls about the ends of a rod that a third one cuts.
    expect_around("max(min(min((x-1)^2 + y^2 + z^2, (x+1)^2 + y^2 + z^2) - 0.25, "
                  "max(abs(x) - 1, y^2 + z^2 - 0.04)), s^2 - x^2 - (y-0.3)^2 - z^2)",
                  "s = \"0.05 + 0.6*t\"", ball, {{0.75, Kind::split}}, {2, 0, 0});
}

// Two bodies melt together, and nothing happens where the blend begins.
TEST(KinkedTimelines, BlendsAreSmooth) {
    const std::string bodies =
        "a = (x - s)^2 + y^2 + z^2 - 0.25; b = (x + s)^2 + y^2 + z^2 - 0.25; ";
    // In the middle each body is k/4 = 0.1 away.
    const Told merged{(0.8 - std::sqrt(0.35)) / 0.6, Kind::merge};
    const auto expect_merge = [&](const std::string& blend, const std::string& parameters) {
        expect_around(bodies + blend, "s = \"0.8 - 0.6*t\"\n" + parameters, {2, 0, 0}, {merged},
                      {1, 0, 0});
    };
    expect_merge("smoothmin(a, b, 0.4)", "");
    expect_merge("smoothmin(b, a, k)", "k = 0.4");
    expect_merge("min(a, b) - max(0.4 - abs(a - b), 0)^2/1.6", "");
    expect_merge("-(max(k - abs(b - a), 0)^2/(4*k)) + min(a, b)", "k = 0.4");
    expect_merge("h = min(max(0.5 + 0.5*(b - a)/0.4, 0), 1); b*(1 - h) + a*h - 0.4*h*(1 - h)", "");
    // A plane rises below a ball. At s = 0.9046 it reaches the blend's rim below the ball's middle.
    expect_around("smoothmin((x - 0.1)^2 + (y + 0.1)^2 + z^2 - 1, z + 2 - s, 0.2)",
                  "s = \"0.88 + 0.04*t\"", {2, 0, 0}, {}, {2, 0, 0});
}

class RandomSolid {
public:
    explicit RandomSolid(unsigned seed)
        : random_(seed) {}

    Moving moving() {
        const std::string formula = tree(3);
        return {formula, "{ box = [[-3.11, -3.05, -3.17], [3.07, 3.13, 3.03]] }", parameters_,
                in_a_second};
    }

private:
    double number(double low, double high) {
        return low + (high - low) * double(random_()) / 0x1p32;
    }
    std::string parameter(double low, double high, double change) {
        const std::string name = fmt::format("p{}", count_++);
        parameters_ += random_() % 2 == 0
                           ? fmt::format("{} = \"{:.4f} + {:.4f}*t\"\n", name, number(low, high),
                                         number(-change, change))
                           : fmt::format("{} = \"{:.4f} + {:.4f}*sin({:.4f}*t + {:.4f})\"\n", name,
                                         number(low, high), number(-change, change), number(1, 3),
                                         number(0, 6));
        return name;
    }
    std::string body() {
        std::array<std::string, 3> at;
        for (std::size_t k = 0; k < 3; ++k)
            at[k] = fmt::format("({} - {})", "xyz"[k], parameter(-0.9, 0.9, 0.6));
        switch (random_() % 3) {
        case 0:
            return fmt::format("({}^2 + {}^2 + {}^2 - {}^2)", at[0], at[1], at[2],
                               parameter(0.35, 0.6, 0.08));
        case 1:
            return fmt::format("(sqrt({}^2 + {}^2 + {}^2) - {})", at[0], at[1], at[2],
                               parameter(0.35, 0.6, 0.08));
        default:
            return fmt::format("((sqrt({}^2 + {}^2) - {})^2 + {}^2 - {}^2)", at[0], at[1],
                               parameter(0.35, 0.5, 0.3), at[2], parameter(0.15, 0.22, 0.02));
        }
    }
    std::string tree(int bodies) {
        if (bodies == 1) return body();
        const std::string a = tree(bodies - 1), b = body();
        switch (random_() % 4) {
        case 0:
            return fmt::format("max({}, -({}))", a, b);
        case 1:
            return fmt::format("max({}, {})", a, b);
        default:
            return fmt::format("min({}, {})", a, b);
        }
    }

    std::mt19937 random_;
    std::string parameters_;
    int count_ = 0;
};

// Thin parts are lost on grids: two of them must agree before they are asked.
TEST(KinkedTimelines, OfRandomSolidsAreThoseOfGrids) {
    int complete = 0, compared = 0;
    constexpr unsigned draws = 8;
    for (unsigned seed = 1; seed <= draws; ++seed) {
        const Moving moving = RandomSolid(seed).moving();
        SCOPED_TRACE(fmt::format("seed {}: {}\n{}", seed, moving.formula, moving.parameters));
        const scene::Scene scene = moving.scene();
        const Timeline timeline = analyse(scene);
        complete += timeline.is_complete();
        EXPECT_TRUE(timeline.doubts.empty()) << described(timeline);
        for (const Step& step : steps_of(timeline).steps) {
            if (!step.is_proved || !step.solid || !(step.time.hi - step.time.lo > 0.05)) continue;
            const StillScene still(scene, middle(step.time));
            const auto counted = [&](int side) {
                return betti(frame_signs(*scene.surfaces[0].field, still.numbers, still.bounds,
                                         solid_side(scene), side));
            };
            const Betti coarse = counted(72);
            if (coarse != counted(96)) continue;
            EXPECT_EQ(coarse, *step.solid) << middle(step.time);
            ++compared;
        }
    }
    EXPECT_GE(complete, int(draws) - 1);
    EXPECT_GE(compared, 8);
}

} // namespace
} // namespace isomotion::topology
