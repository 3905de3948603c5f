// How shaders find the elements of an array: all of them, by the lists of beams, or by place.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes.h"
#include "synthesis/pass.h"

namespace isomotion::synthesis {
namespace {

enum class Finding { all, lists, place };

void PrintTo(Finding finding, std::ostream* to) {
    *to << (finding == Finding::all ? "all" : finding == Finding::lists ? "lists" : "place");
}

const std::string squared = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";

Finding finding(int count, const std::string& formula, const std::string& isolation = {}) {
    use_shaders_of_source_tree();
    const std::string text = surface_text(formula, every_bounds[0], "hermite") + isolation +
                             fmt::format("[arrays.balls]\ncount = {}\ncx = 'random(i, 0)'\n"
                                         "cy = 'random(i, 1)'\ncz = 'random(i, 2)'\n",
                                         count);
    const Passes passes = assemble(scene_of(text));
    return has_lists(passes)         ? Finding::lists
           : array_with_grid(passes) ? Finding::place
                                     : Finding::all;
}

TEST(Elements, OfALinearSumAreFoundByListsAndManyByPlace) {
    const std::string sum = "sum(balls, exp(-20*" + squared + ")) - 1";
    EXPECT_EQ(finding(8, sum), Finding::all);
    EXPECT_EQ(finding(9, sum), Finding::lists);
    EXPECT_EQ(finding(500, sum), Finding::lists);
    EXPECT_EQ(finding(501, sum), Finding::place);
    EXPECT_EQ(finding(501, sum, "beam = true\n"), Finding::lists);
    EXPECT_EQ(finding(501, sum, "beam = false\n"), Finding::all);
}

TEST(Elements, OfOtherSumsAreFoundByPlaceAboveSixtyFour) {
    const std::string sum = "min(1 - sum(balls, exp(-20*" + squared + ")), z + 1)";
    EXPECT_EQ(finding(64, sum), Finding::all);
    EXPECT_EQ(finding(65, sum), Finding::place);
    EXPECT_EQ(finding(65, sum, "beam = false\n"), Finding::all);
}

// Of boxes as of balls.
TEST(Elements, OfTheLeastKeyAreFoundByPlaceAboveSixtyFour) {
    for (const std::string& key :
         {squared + " - 0.01", std::string("max(abs(x-cx), max(abs(y-cy), abs(z-cz))) - 0.1")}) {
        const std::string least = "least(balls, " + key + ")";
        EXPECT_EQ(finding(64, least), Finding::all) << key;
        EXPECT_EQ(finding(65, least), Finding::place) << key;
        EXPECT_EQ(finding(65, least, "beam = false\n"), Finding::all) << key;
    }
}

} // namespace
} // namespace isomotion::synthesis
