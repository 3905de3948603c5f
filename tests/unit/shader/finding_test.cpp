// How shaders find the elements of an array: all of them, by the lists of beams, or by place.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes.h"
#include "shader/finding_elements.h"
#include "shader/pass.h"

namespace isomotion::shader {
namespace {

enum class Finding { all, lists, place };

void PrintTo(Finding finding, std::ostream* to) {
    *to << (finding == Finding::all ? "all" : finding == Finding::lists ? "lists" : "place");
}

const std::string squared = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";

scene::Scene scene_with(int count, const std::string& formula, const std::string& isolation = {},
                        const std::string& method = "hermite") {
    return scene_of(surface_text(formula, every_bounds[0], method) + isolation +
                    fmt::format("[arrays.balls]\ncount = {}\ncx = 'random(i, 0)'\n"
                                "cy = 'random(i, 1)'\ncz = 'random(i, 2)'\n",
                                count));
}

Finding finding(const scene::Scene& scene, const Drawing& drawing = {}) {
    use_shaders_of_source_tree();
    const Passes passes = assemble(scene, {}, drawing);
    return has_lists(passes)         ? Finding::lists
           : array_with_grid(passes) ? Finding::place
                                     : Finding::all;
}

Finding finding(int count, const std::string& formula, const std::string& isolation = {}) {
    return finding(scene_with(count, formula, isolation));
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

std::string blobs(int sharpness) {
    return fmt::format("sum(balls, exp(-{}*{})) - 1", sharpness, squared);
}

Finding at_size(const scene::Scene& scene, int side) {
    return finding(scene, {.pixels = std::int64_t(side) * side});
}

// The only number of pixels at which the shaders of a scene with one surface change; 0 if there is
// none.
std::int64_t fewest_pixels_for_lists(const scene::Scene& scene) {
    const std::vector<std::int64_t> sizes = sizes_of_change(scene);
    EXPECT_LE(sizes.size(), 1u);
    return sizes.empty() ? 0 : sizes[0];
}

TEST(Elements, OfASparseCrowdAreFoundByPlaceInSmallPicturesAndByListsInLargeOnes) {
    for (const int count : {65, 100, 500, 501, 2000}) {
        SCOPED_TRACE(count);
        for (const int sharpness : {20, 200, 2000, 20'000}) {
            const scene::Scene scene = scene_with(count, blobs(sharpness));
            const std::int64_t fewest = fewest_pixels_for_lists(scene);
            EXPECT_EQ(finding(scene, {.pixels = fewest - 1}), Finding::place) << sharpness;
            EXPECT_EQ(finding(scene, {.pixels = fewest}), Finding::lists) << sharpness;
        }
    }
}

TEST(Elements, AreFoundByPlaceInLargerPicturesTheSmallerTheyAre) {
    std::int64_t before = 0;
    for (const int sharpness : {20, 100, 500, 2500}) {
        const std::int64_t fewest = fewest_pixels_for_lists(scene_with(400, blobs(sharpness)));
        EXPECT_GT(fewest, before) << sharpness;
        before = fewest;
    }
    EXPECT_EQ(at_size(scene_with(400, blobs(20)), 256), Finding::lists);
    EXPECT_EQ(at_size(scene_with(400, blobs(2500)), 256), Finding::place);
    EXPECT_EQ(at_size(scene_with(1500, blobs(20)), 512), Finding::lists);
    EXPECT_EQ(at_size(scene_with(2001, blobs(20)), 512), Finding::place);
}

// Which proofs succeed is not to depend on the picture's size, and the paper's methods look at all.
TEST(Elements, OfProvedScenesAndOtherMethodsAreFoundByTheirNumberAlone) {
    for (const int side : {32, 2048}) {
        const auto found = [&](int count, const std::string& isolation, const std::string& method) {
            return at_size(scene_with(count, blobs(500), isolation, method), side);
        };
        EXPECT_EQ(found(500, "certify = true\n", "hermite"), Finding::lists) << side;
        EXPECT_EQ(found(501, "certify = true\n", "hermite"), Finding::place) << side;
        EXPECT_EQ(found(500, "", "interval"), Finding::all) << side;
        EXPECT_EQ(found(501, "", "interval"), Finding::place) << side;
    }
    EXPECT_EQ(fewest_pixels_for_lists(scene_with(300, blobs(500), "certify = true\n")), 0);
    EXPECT_EQ(fewest_pixels_for_lists(scene_with(300, blobs(500), "", "interval")), 0);
    EXPECT_EQ(fewest_pixels_for_lists(scene_with(300, blobs(500), "beam = true\n")), 0);
    EXPECT_EQ(fewest_pixels_for_lists(scene_with(300, blobs(500), "beam = false\n")), 0);
    EXPECT_EQ(fewest_pixels_for_lists(scene_with(300, "least(balls, " + squared + ") - 0.01")), 0);
    EXPECT_EQ(fewest_pixels_for_lists(scene_with(300, "min(" + blobs(500) + ", z + 1)")), 0);
    EXPECT_TRUE(sizes_of_change(scene_with(300, blobs(500)), {.writes_buffers = false}).empty());
    EXPECT_TRUE(sizes_of_change(scene_with(300, blobs(500)), on_page).empty());
    EXPECT_EQ(fewest_pixels_for_lists(scene_with(300, "x + sum(balls, sin(cx*y + cy*z + cz))")), 0);
}

} // namespace
} // namespace isomotion::shader
