// Enclosures of F and its derivatives over boxes hold what doubles say at points of the boxes.
#include <random>

#include "topology/field/motion.h"
#include "topology/field/moving_field.h"
#include "topology/moving.h"
#include "topology/search/comoving_fit.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

const std::vector<Moving> moving_surfaces{
    {"T - exp(-((x - s)^2 + y^2 + z^2)) - exp(-((x + s)^2 + y^2 + z^2))", "{ sphere = 3 }",
     "T = 0.5\ns = \"1 + sin(t)/2\""},
    {"sum(blobs, exp(-8*((x - cx)^2 + (y - cy)^2 + (z - cz)^2))) - T", "{ sphere = 2 }",
     "T = \"0.5 + t/10\"",
     "[arrays.blobs]\ncount = 9\ncx = \"cos(i + t)\"\ncy = \"sin(i*1.7)*w\"\ncz = \"random(i, "
     "3)\"\n"
     "w = \"1 + i*t/20\""},
    // Terms with kinks, poles, logarithms and steps, which Taylor's formula must not take.
    {"sum(blobs, abs(x - cx)*w/(4 + (y - cy)^2)) + log(2 + sum(blobs, max(0, 0.3 - x - cy)^2)) - T",
     "{ sphere = 2 }", "T = \"0.5 + t/10\"",
     "[arrays.blobs]\ncount = 9\ncx = \"cos(i + t)\"\ncy = \"sin(i*1.7)*w\"\nw = \"1 + i*t/20\""},
    {"exp(-sum(blobs, w/(1 + 8*((x - cx)^2 + (y - cy)^2 + z^2))^2)) + sum(tips, sqrt((x - a)^2 + "
     "y^2 + z^2)) - T",
     "{ box = [[-1, -1, -1], [1, 1, 1]] }", "T = \"0.5 + t/10\"",
     "[arrays.blobs]\ncount = 9\ncx = \"cos(i + t)\"\ncy = \"sin(i*1.7)*w\"\nw = \"1 + i*t/20\"\n"
     "[arrays.tips]\ncount = 3\na = \"cos(i*2 + t)\""},
    {"abs(x)^m + abs(y)^m + abs(z)^m - 1", "{ box = [[-1, -1, -1], [1, 1, 1]] }",
     "m = { keys = [[0, 2.2], [0.4, 3], [1, 5]], ease = \"cubic\" }"},
    {"max(min(x*y + c, z), x^2 + y^2 + z^2 - 1)", "{ box = [[-1, -1, \"-c\"], [1, 1, \"1 + c\"]] }",
     "c = \"0.3 + t\""},
    {"least(blobs, (x - cx)^2 + (y - cy)^2 + w*z^2) + 0.1*greatest(blobs, sin(x + cx)*w) - T",
     "{ sphere = 2 }", "T = \"0.5 + t/10\"",
     "[arrays.blobs]\ncount = 9\ncx = \"cos(i + t)\"\ncy = \"sin(i*1.7)*w\"\nw = \"1 + i*t/20\""},
    {"chebyshev(8, x) + chebyshev(8, y)*c + sqrt(x^2 + z^2 + 0.01)", "{ sphere = 1.1 }",
     "c = \"tanh(t) + atan(t)\""},
};

bool holds(const Interval& enclosure, double value) {
    // The sample has rounding errors of its own.
    const double slack = 1e-9 * (1 + std::abs(value));
    return enclosure.lo <= value + slack && value - slack <= enclosure.hi;
}

const ComovingFrame drift{0.4, {0.25, -0.5, 0.125}, 0.75};

int elements_in(const Elements& elements) {
    int all = 0;
    for (const auto& array : elements.bindings.arrays) all += array.count;
    return all;
}

// At least this many boxes over all surfaces and strata.
constexpr int boxes_in_all = 100'000;

TEST(MovingField, EnclosesWhatItIsAtPoints) {
    const unsigned seed = 20'240'611;
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    int boxes = 0, left_out = 0;
    struct Case {
        Motion motion;
        Stratum stratum;
        ComovingFrame drift;
    };
    std::vector<Case> all;
    for (const Moving& moving : moving_surfaces) {
        for (const Clock clock : {Clock::time, Clock::track_if_one}) {
            const Motions parts = motions(moving.scene(), Side::negative, {0.1, 0.9}, clock);
            for (const Motion& motion : parts.pieces) {
                all.push_back({motion, {}, {}});
                all.push_back({motion, {}, drift});
                if (motion.shape == scene::Bounds::Shape::sphere) continue;
                using enum Stratum::End;
                all.push_back({motion, {{low, free, free}}, {}});
                all.push_back({motion, {{free, high, low}}, {}});
                all.push_back({motion, {{high, low, high}}, {}});
            }
        }
    }
    const int each = boxes_in_all / int(all.size()) + 1;
    for (const Case& now : all) {
        const MovingField field(now.motion, now.stratum, now.drift);
        Enclosures enclosures(field);
        Numbers numbers(field);
        const auto n = std::size_t(field.variables()), d = n - 1;
        for (int k = 0; k < each; ++boxes) {
            // A family of boxes that share their elements.
            const double size = std::pow(2, -20 * unit(random));
            Box around{};
            for (std::size_t i = 0; i < n; ++i) {
                const Interval whole = field.domain()[i];
                const double length = (whole.hi - whole.lo) * size;
                const double low = whole.lo + (whole.hi - whole.lo - length) * unit(random);
                around[i] = {low, low + length};
            }
            Elements near = enclosures.near(around, enclosures.all(), 1e-3 * unit(random));
            const int before = elements_in(near);
            if (unit(random) < 0.5) near = enclosures.expanded(around, near, unit(random));
            left_out += before - elements_in(near);
            std::vector<Box> family;
            std::vector<Point> samples;
            for (int b = 0; b < 37 && k < each; ++b, ++k) {
                Box box{};
                Point sample{};
                for (std::size_t i = 0; i < n; ++i) {
                    const double p = unit(random), q = unit(random);
                    const double length = around[i].hi - around[i].lo;
                    box[i] = {around[i].lo + length * std::min(p, q),
                              around[i].lo + length * std::max(p, q)};
                    const double part = std::round(4 * unit(random)) / 4; // ends, often
                    sample[i] = std::clamp(box[i].lo + (box[i].hi - box[i].lo) * part, box[i].lo,
                                           box[i].hi);
                }
                family.push_back(box);
                samples.push_back(sample);
            }
            boxes += int(family.size()) - 1;
            std::vector<Jet<Interval>> jets, slopes;
            std::vector<Interval> values;
            enclosures.jets(near, family, jets);
            enclosures.gradients(near, family, slopes);
            enclosures.values(near, family, values);
            for (std::size_t b = 0; b < family.size(); ++b) {
                const Jet<double> at = numbers.jet(samples[b]);
                ASSERT_TRUE(holds(values[b], at.value));
                ASSERT_TRUE(holds(slopes[b].value, at.value));
                ASSERT_TRUE(holds(jets[b].value, at.value));
                for (std::size_t i = 0; i < n; ++i) {
                    ASSERT_TRUE(holds(slopes[b].gradient[i], at.gradient[i]));
                    ASSERT_TRUE(holds(jets[b].gradient[i], at.gradient[i]));
                    for (std::size_t j = 0; i < d && j < n; ++j) {
                        ASSERT_TRUE(holds(jets[b].hessian[i][j], at.hessian[i][j]));
                    }
                }
            }
        }
    }
    EXPECT_GE(boxes, boxes_in_all);
    EXPECT_GE(left_out, boxes_in_all / 100); // by Taylor's formula
}

// The expressions of a motion are the values of the animation.
TEST(MovingField, IsTheFieldOfTheScene) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const Moving& moving : moving_surfaces) {
        const scene::Scene scene = moving.scene();
        const Motions parts = motions(scene, Side::positive, {0.1, 0.9}, Clock::time);
        for (const Motion& motion : parts.pieces) {
            const MovingField field(motion, {});
            Numbers numbers(field);
            for (int k = 0; k < 50; ++k) {
                const double t = middle(motion.clock) + 0.49 * width(motion.clock) * unit(random);
                const Point p{unit(random), unit(random), unit(random), t};
                const animation::Values values = scene.surfaces[0].animation.at(t);
                formula::Bindings<double> bindings;
                bindings.parameters = values.tracks;
                bindings.arrays = values.arrays;
                const double expected = formula::FieldEvaluator<double>(*scene.surfaces[0].field)
                                            .value(bindings, {p[0], p[1], p[2]});
                ASSERT_NEAR(numbers.jet(p).value, -expected, 1e-12);
            }
        }
    }
}

TEST(MovingField, OfCoordinatesThatDriftIsTheSame) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const Moving& moving : moving_surfaces) {
        const Motions parts = motions(moving.scene(), Side::negative, {0.1, 0.9}, Clock::time);
        for (const Motion& motion : parts.pieces) {
            const MovingField rests(motion, {}), drifts(motion, {}, drift);
            Numbers numbers(rests), drifting(drifts);
            for (int k = 0; k < 50; ++k) {
                Point x{}, p{};
                for (std::size_t i = 0; i < 4; ++i) {
                    const Interval whole = rests.domain()[i];
                    x[i] = whole.lo + (whole.hi - whole.lo) * unit(random);
                }
                p[3] = x[3];
                for (std::size_t i = 0; i < 3; ++i) p[i] = drift.p(i, x[i], x[3]);
                const Jet<double> at = numbers.jet(x), there = drifting.jet(p);
                ASSERT_NEAR(there.value, at.value, 1e-9 * (1 + std::abs(at.value)));
                const double scale = 1 + (x[3] - drift.from) * drift.growth;
                for (std::size_t i = 0; i < 3; ++i) {
                    ASSERT_NEAR(there.gradient[i], scale * at.gradient[i],
                                1e-9 * (1 + std::abs(at.gradient[i])));
                    ASSERT_TRUE(holds(drifts.x(at_point(p), i), x[i]));
                }
                // All that is within the bounds is in the domain.
                Enclosures enclosures(rests);
                if (enclosures.place(at_point(x)) != Enclosures::Place::inside) continue;
                for (std::size_t i = 0; i < 3; ++i) ASSERT_TRUE(holds(drifts.domain()[i], p[i]));
            }
        }
    }
}

// A lattice of blobs that grows, one that flies, and a surface that only changes its level.
TEST(ComovingFrame, IsThatOfTheSurface) {
    const auto drift_in = [](const Moving& moving) {
        const Motions parts = motions(moving.scene(), Side::negative, {0, 1}, Clock::time);
        return fit_comoving_frame(MovingField(parts.pieces.at(0), {}));
    };
    const std::string blobs = "sum(blobs, exp(-8*((x - cx)^2 + (y - cy)^2 + (z - cz)^2))) - T";
    const std::string places = "[arrays.blobs]\ncount = 9\nux = \"i - 3*floor(i/3) - 1\"\n"
                               "uy = \"floor(i/3) - 1\"\n";
    const ComovingFrame grows = drift_in({blobs, "{ sphere = 3 }", "T = 0.3\ns = \"0.75 + 0.5*t\"",
                                          places + "cx = \"s*ux\"\ncy = \"s*uy\"\ncz = 0\n"});
    EXPECT_NEAR(grows.growth, 0.5, 0.2);
    for (const double by : grows.by) EXPECT_NEAR(by, 0, 0.2);
    const ComovingFrame flies = drift_in({blobs, "{ sphere = 4 }", "T = 0.3\ns = \"2*t\"",
                                          places + "cx = \"ux - s\"\ncy = \"uy + s/2\"\ncz = 0\n"});
    EXPECT_NEAR(flies.growth, 0, 0.1);
    EXPECT_NEAR(flies.by[0], -2, 0.3);
    EXPECT_NEAR(flies.by[1], 1, 0.3);
    EXPECT_NEAR(flies.by[2], 0, 0.3);
    EXPECT_TRUE(drift_in({"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + c", "{ sphere = 3 }",
                          "c = \"20 - 10*t\""})
                    .rests());
}

// Slopes of the derivatives are what the derivatives change by.
TEST(MovingField, HasTheDerivativesOfWhatItIs) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const Moving& moving : {moving_surfaces[0], moving_surfaces[1], moving_surfaces[4]}) {
        const Motions parts = motions(moving.scene(), Side::negative, {0.1, 0.9}, Clock::time);
        const MovingField field(parts.pieces[0], {});
        Numbers numbers(field);
        for (int k = 0; k < 50; ++k) {
            const Point p{unit(random), unit(random), unit(random), 0.5 + 0.3 * unit(random)};
            const Jet<double> at = numbers.jet(p);
            for (std::size_t i = 0; i < 4; ++i) {
                constexpr double h = 1e-5;
                Point before = p, after = p;
                before[i] -= h;
                after[i] += h;
                const Jet<double> low = numbers.jet(before), high = numbers.jet(after);
                ASSERT_NEAR(at.gradient[i], (high.value - low.value) / (2 * h), 1e-4);
                for (std::size_t j = 0; j < 3; ++j) {
                    ASSERT_NEAR(at.hessian[j][i], (high.gradient[j] - low.gradient[j]) / (2 * h),
                                1e-3);
                }
            }
        }
    }
}

// Across kinks, jumps of slopes and ends of domains too. Krawczyk's operator needs no less.
TEST(MovingField, EnclosesHowMuchItsSlopesChange) {
    const unsigned seed = 20'261'121;
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    int across = 0;
    for (const std::string formula :
         {"sqrt(x - c) + y*z", "asin(x + c) + y*z", "acos(x*y + c) - z", "sqrt(x*y - c)*z",
          "abs(x + c)*y - z", "max(x*y, z + c)", "min(x*y, z + c)", "least(blobs, x*cx - c) + y*z",
          "sum(blobs, sqrt(x*cx - c)) + y*z"}) {
        SCOPED_TRACE(formula);
        const Moving moving{formula, "{ box = [[-2, -2, -2], [2, 2, 2]] }", "c = \"t - 0.5\"",
                            "[arrays.blobs]\ncount = 3\ncx = \"i + 1\""};
        const Motions parts = motions(moving.scene(), Side::negative, {0, 1}, Clock::time);
        const MovingField field(parts.pieces.at(0), {});
        Enclosures enclosures(field);
        Numbers numbers(field);
        for (int k = 0; k < 4000; ++k) {
            Point p{1.5 * unit(random), 1.5 * unit(random), 1.5 * unit(random),
                    0.5 + 0.4 * unit(random)};
            const auto j = std::size_t(k % 4);
            Point q = p;
            q[j] += (j == 3 ? 0.1 : 0.4) * unit(random);
            Box box{};
            for (std::size_t i = 0; i < 4; ++i) {
                box[i] = {std::min(p[i], q[i]), std::max(p[i], q[i])};
            }
            const Jet<double> from = numbers.jet(p), to = numbers.jet(q);
            const Jet<Interval> jet = enclosures.jet(box);
            for (std::size_t i = 0; i < 3; ++i) {
                const double change = (to.gradient[i] - from.gradient[i]) / (q[j] - p[j]);
                if (!std::isfinite(change)) continue;
                // The rounding of doubles, over the distance.
                const double slack = 1e-12 *
                                     (1 + std::abs(from.gradient[i]) + std::abs(to.gradient[i])) /
                                     std::abs(q[j] - p[j]);
                ASSERT_LE(jet.hessian[i][j].lo, change + slack) << i << " by " << j;
                ASSERT_GE(jet.hessian[i][j].hi, change - slack) << i << " by " << j;
                across += std::isinf(magnitude(jet.hessian[i][j]));
            }
        }
    }
    EXPECT_GT(across, 1000); // boxes that do hold a kink or an end
}

} // namespace
} // namespace isomotion::topology
