// What a formula is rid of within its bounds: quotients that have a value everywhere are no kinks.
#include "topology/field/idle_parts.h"

#include "topology/field/kinks.h"
#include "topology/moving.h"
#include "topology/search/critical.h"

namespace isomotion::topology {
namespace {

bool has_kinks(const std::string& formula) {
    const Moving moving{formula, "{ box = [[-2.1, -2, -1.9], [1.8, 2, 2.2]] }", "T = \"0.1 + t\""};
    const Motions all = motions(moving.scene(), Side::negative, {0, 1});
    return KinkTree(bound_formula(all.pieces.front()), 3).has_kinks();
}

TEST(IdleParts, QuotientsOfWhatIsNever0HaveNoKinks) {
    for (const char* formula : {"(x^2 + y*z)/(3 - T) - 1", "x^2 + y^2/(1 + z^2) - T",
                                "x/(x*x - x*y + y*y + 2) + z - T", "(3 + sin(x + y))/(z - y) - T",
                                "log(2 + y/(5 + x*z)) - T*x", "x*y/(2 + cos(y + T)) - z"}) {
        EXPECT_FALSE(has_kinks(formula)) << formula;
    }
    // 0/0 at a point, along a curve, and at some moment.
    for (const char* formula : {"x*y/(x^2 + y^2) - T", "(x - T)/z - y", "x*y/(T - 0.6) + z",
                                "(x^2 + y^2)/(x - y + T) + z", "x*y/(1 + x^2) + abs(z) - T"}) {
        EXPECT_TRUE(has_kinks(formula)) << formula;
    }
}

// Of a ball that is stretched by a quotient: where its events are known.
TEST(IdleParts, EventsOfQuotientsAreThoseOfProducts) {
    const std::string box = "{ box = [[-1.5, -1.5, -1.5], [1.5, 1.5, 1.5]] }";
    const Moving quotient{"(x^2 + y^2 + z^2 + x*y/2 + T)/(3 + x*z)", box, "T = \"t - 0.5\""};
    const Moving product{"x^2 + y^2 + z^2 + x*y/2 + T", box, "T = \"t - 0.5\""};
    SearchCost of_quotient, of_product;
    const Timeline found = find_events(quotient.scene(), Side::negative, {0, 1}, {}, &of_quotient);
    expect_events(found, {{0.5, 1, 0, false}});
    expect_events(find_events(product.scene(), Side::negative, {0, 1}, {}, &of_product),
                  {{0.5, 1, 0, false}});
    EXPECT_LT(of_quotient.boxes, 20 * of_product.boxes);
}

} // namespace
} // namespace isomotion::topology
