#include "formula/hessian.h"

#include "catalogue.h"
#include "central_difference.h"

namespace isomotion::formula {
namespace {

using Second = std::array<double, 6>;

Second second_of(const Field& field, const Point& p,
                 const Bindings<double>& bindings = test_bindings()) {
    Second result{};
    const Program program = hessian(field);
    Evaluator<double>(program).point(bindings, p, result);
    return result;
}

TEST(Hessian, ComesInTheOrderOfTheUpperTriangle) {
    const Field field = make_field("x^2 + 3*x*y + 5*x*z + 7*y^2/2 + 11*y*z + 13*z^2/2", {});
    EXPECT_EQ(second_of(field, {0.3, -2, 7}), (Second{2, 3, 5, 7, 11, 13}));
}

TEST(Hessian, OfAPlaneIsZero) {
    EXPECT_EQ(second_of(make_field("x - 2*y + 3*z", {}), {1, 2, 3}), Second{});
}

// Each of two branches rests where the other counts, at the end of what sqrt and acos take.
TEST(Hessian, OfABranchThatRestsAtAnInfiniteSlopeIsZero) {
    for (const char* resting : {"sqrt(max(x, 1) - 1)", "acos(max(x, 1))", "asin(min(-x, -1))",
                                "log(max(x, 1) + sqrt((max(x, 1) - 1)*(max(x, 1) + 1)))"}) {
        const Field field = make_field(std::string("cos(14*") + resting + ") + x^2", {});
        EXPECT_EQ(second_of(field, {0.5, 0.3, 0.2}), (Second{2, 0, 0, 0, 0, 0})) << resting;
    }
}

// Directions of rays are inputs of the graph too, and no coordinates.
TEST(Hessian, LeavesTheFieldAsItWas) {
    const Field field = make_field("x^3*y + exp(z)", {});
    const std::size_t nodes = field.graph.size();
    hessian(field);
    EXPECT_EQ(field.graph.size(), nodes);
}

TEST(Hessian, ReadsNoMoreOfAnArrayThanTheField) {
    const Field field =
        make_field("sum(blobs, weight*exp(-r*((x-cx)^2 + y^2)))", test_vocabulary());
    for (const Instruction& now : hessian(field).instructions) {
        if (now.kind != Instruction::Kind::operation || now.op != Op::element) continue;
        const auto& packed = field.packing[std::size_t(now.index)];
        EXPECT_TRUE(std::count(packed.begin(), packed.end(), now.second)) << now.second;
    }
}

TEST(Hessian, IsAStructInGlsl) {
    const Field field = make_field("x*y + z^2", {});
    EXPECT_EQ(glsl_hessian(hessian(field), field.packing),
              R"(struct Hessian { float xx, xy, xz, yy, yz, zz; };
Hessian field_hessian(vec3 p) {
    return Hessian(0.0, 1.0, 0.0, 0.0, 0.0, 2.0);
}
)");
}

class HessianOfCatalogue : public testing::TestWithParam<CatalogueSurface> {};

TEST_P(HessianOfCatalogue, AgreesWithDifferencesOfTheGradient) {
    const CatalogueField surface(GetParam());
    FieldEvaluator<double> field(surface.field);
    std::vector<Point> points;
    for (const Point& p : nasty_points(GetParam().reach)) {
        if (!at_kink(GetParam(), p)) points.push_back(p);
    }
    constexpr std::uint64_t seed = 24;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int k = 0; k < 10; ++k) points.push_back(random.point(GetParam().reach));
    for (const Point& p : points) {
        SCOPED_TRACE(testing::PrintToString(p));
        const Second claimed = second_of(surface.field, p, surface.bindings);
        std::size_t at = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = i; j < 3; ++j, ++at) {
                const auto slope = [&](double h) {
                    Point q = p;
                    q[j] += h;
                    return field.gradient(surface.bindings, q)[i];
                };
                EXPECT_LT(slope_error(slope, claimed[at], 0.1), 1e-6) << i << j;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, HessianOfCatalogue, testing::ValuesIn(catalogue()),
                         [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace isomotion::formula
