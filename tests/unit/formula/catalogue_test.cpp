#include "catalogue.h"

#include <cmath>

#include "central_difference.h"
#include "formula/graph/derivative.h"

namespace isomotion::formula {
namespace {

class Catalogue : public testing::TestWithParam<CatalogueSurface> {
protected:
    std::vector<Point> sample(std::uint64_t seed, int random_points) const {
        std::vector<Point> points;
        for (const Point& p : nasty_points(GetParam().reach)) {
            if (!at_kink(GetParam(), p)) points.push_back(p);
        }
        Random random(seed);
        for (int k = 0; k < random_points; ++k) points.push_back(random.point(GetParam().reach));
        return points;
    }
};

TEST_P(Catalogue, GradientAgreesWithDifferences) {
    const CatalogueField surface(GetParam());
    FieldEvaluator<double> field(surface.field);
    constexpr std::uint64_t seed = 21;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    for (const Point& p : sample(seed, 30)) {
        SCOPED_TRACE(testing::PrintToString(p));
        const Point gradient = field.gradient(surface.bindings, p);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto value = [&](double h) {
                Point q = p;
                q[axis] += h;
                return field.value(surface.bindings, q);
            };
            EXPECT_LT(slope_error(value, gradient[axis], 0.2), 1e-7) << "axis " << axis;
        }
    }
}

TEST_P(Catalogue, SecondDerivativesAgreeWithDifferences) {
    const CatalogueField surface(GetParam());
    FieldEvaluator<double> field(surface.field);
    Graph g = surface.field.graph;
    std::array<std::vector<NodeId>, 3> axes;
    for (std::size_t k = 0; k < 3; ++k) {
        axes[k].assign(3, g.constant(0));
        axes[k][k] = g.constant(1);
    }
    constexpr std::uint64_t seed = 22;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    for (std::size_t i = 0; i < 3; ++i) {
        const NodeId first = differentiate_inputs(g, surface.field.root, axes[i]);
        for (std::size_t j = 0; j < 3; ++j) {
            const Program second = schedule_lowered(g, differentiate_inputs(g, first, axes[j]));
            for (const Point& p : sample(seed, 5)) {
                SCOPED_TRACE(testing::Message() << i << j << ' ' << testing::PrintToString(p));
                const auto slope = [&](double h) {
                    Point q = p;
                    q[j] += h;
                    return field.gradient(surface.bindings, q)[i];
                };
                // soft_blobs is only once differentiable at r = R, which no point here meets.
                EXPECT_LT(slope_error(slope, run(second, p, surface.bindings), 0.2), 1e-7);
            }
        }
    }
}

TEST_P(Catalogue, AlongARayIsTheGradientTimesItsDirection) {
    const CatalogueField surface(GetParam());
    FieldEvaluator<double> field(surface.field);
    constexpr std::uint64_t seed = 23;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (const Point& p : sample(seed, 20)) {
        SCOPED_TRACE(testing::PrintToString(p));
        const Point d = random.point(1);
        const auto [value, slope] = field.directional(surface.bindings, p, d);
        const Point g = field.gradient(surface.bindings, p);
        const double expected = g[0] * d[0] + g[1] * d[1] + g[2] * d[2];
        const double size = std::abs(g[0]) + std::abs(g[1]) + std::abs(g[2]) + std::abs(value);
        EXPECT_EQ(value, field.value(surface.bindings, p));
        EXPECT_NEAR(slope, expected, 1e-9 * (1 + size));
    }
}

TEST_P(Catalogue, IsFiniteEverywhereInThePictureAndAround) {
    const CatalogueField surface(GetParam());
    FieldEvaluator<double> in_double(surface.field);
    FieldEvaluator<float> in_float(surface.field);
    const auto narrow = convert<float>(surface.bindings);
    const bool pole = GetParam().kink == Kink::centres;
    for (const double scale : {1.0, 2.0, 6.0}) {
        for (const Point& p : nasty_points(GetParam().reach * scale)) {
            SCOPED_TRACE(testing::PrintToString(p));
            const std::array<float, 3> q{float(p[0]), float(p[1]), float(p[2])};
            EXPECT_TRUE(std::isfinite(in_double.value(surface.bindings, p)));
            EXPECT_TRUE(std::isfinite(in_float.value(narrow, q)));
            if (pole && at_kink(GetParam(), p)) continue; // it has no derivative
            for (const double g : in_double.gradient(surface.bindings, p)) {
                EXPECT_TRUE(std::isfinite(g));
            }
            for (const float g : in_float.gradient(narrow, q)) EXPECT_TRUE(std::isfinite(g));
            for (const float g : in_float.directional(narrow, q, {0.6F, 0, -0.8F})) {
                EXPECT_TRUE(std::isfinite(g));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Catalogue, testing::ValuesIn(catalogue()),
                         [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace isomotion::formula
