// The two halves of the sinusoidal Chmutov surfaces meet at |x| = 1, where acos and acosh have
// infinite slopes.
#include <cmath>

#include <gmock/gmock.h>

#include "surface_file.h"

namespace isomotion::catalogue {
namespace {

class Sinusoidal : public testing::TestWithParam<int> {
protected:
    const int n = GetParam();
    const Used trigonometric = used("chmutov_" + std::to_string(n) + "_trig");
    const Used products = used("chmutov_" + std::to_string(n));
};

template<class T> std::vector<T> around_one() {
    std::vector<T> places;
    for (const T side : {T(1), T(-1)}) {
        T out = side, in = side;
        places.push_back(side);
        for (int k = 0; k < 3; ++k) {
            places.push_back(out = std::nextafter(out, 2 * side));
            places.push_back(in = std::nextafter(in, T(0)));
        }
        for (const double off : {1e-7, 1e-6, 1e-4, 1e-3}) {
            places.push_back(side * T(1 + off));
            places.push_back(side * T(1 - off));
        }
    }
    return places;
}

TEST_P(Sinusoidal, ValuesAndSlopesMeetAtOne) {
    formula::FieldEvaluator<double> trig(trigonometric.field()), expected(products.field());
    const auto bindings = trigonometric.bindings();
    for (const double x : around_one<double>()) {
        SCOPED_TRACE(testing::Message() << "x - 1 = " << std::abs(x) - 1);
        for (const formula::Point& p :
             {formula::Point{x, 0.3, -0.7}, {-0.2, x, 0.6}, {0.1, -0.4, x}, {x, x, -x}}) {
            const double value = expected.value(bindings, p);
            EXPECT_NEAR(trig.value(bindings, p), value, 1e-12 * n * n * (1 + std::abs(value)));
            const auto slopes = trig.gradient(bindings, p);
            const auto all = expected.gradient(bindings, p);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // On the seam itself the slope is that of the cut-off arguments: 0.
                const double slope = std::abs(p[axis]) == 1 ? 0 : all[axis];
                EXPECT_NEAR(slopes[axis], slope, 1e-5 * n * n * n) << "axis " << axis;
            }
        }
    }
}

TEST_P(Sinusoidal, FloatsKeepTheirDigitsAtOne) {
    formula::FieldEvaluator<float> trig(trigonometric.field());
    formula::FieldEvaluator<double> expected(products.field());
    const auto& floats = trigonometric.at.surfaces[0].bindings;
    const auto doubles = products.bindings();
    for (const float x : around_one<float>()) {
        SCOPED_TRACE(testing::Message() << "x - 1 = " << std::abs(x) - 1);
        for (const float y : {0.3f, x}) {
            const std::array<float, 3> p{x, y, 0.5f};
            const formula::Point q{x, y, 0.5};
            EXPECT_NEAR(trig.value(floats, p), expected.value(doubles, q), 1e-6 * n);
            const auto slopes = trig.gradient(floats, p);
            const auto all = expected.gradient(doubles, q);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double slope = std::abs(q[axis]) == 1 ? 0 : all[axis];
                EXPECT_NEAR(slopes[axis], slope, 1e-3 * n * n) << "axis " << axis;
            }
            EXPECT_TRUE(std::isfinite(trig.directional(floats, p, {0.6f, 0, -0.8f})[1]));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Orders, Sinusoidal, testing::Values(14, 18, 22, 50));

} // namespace
} // namespace isomotion::catalogue
