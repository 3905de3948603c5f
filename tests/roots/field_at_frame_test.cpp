// First roots found from the elements that matter at each place, against those from all elements.
#include "roots/field_at_frame.h"

#include "view.h"

namespace isomotion::roots::field_at_frame_test {
namespace {

std::string scene_text(const std::string& formula, int count) {
    return fmt::format(R"(
[surface]
formula = '''{}'''
bounds = {{ sphere = 1.3 }}
[arrays.p]
count = {}
cx = "2*random(i, 1) - 1"
cy = "1.6*random(i, 2) - 0.8"
cz = "random(i, 3) - 0.5"
[camera]
position = [2.4, 1.2, 1.7]
)",
                       formula, count);
}

const std::string distance = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";

class ManyElements : public testing::TestWithParam<std::string> {};

TEST_P(ManyElements, HaveTheRootsOfTheirSum) {
    const View all(scene_of(scene_text(GetParam(), 150)), 24, 24, {.evaluations = 4000});
    EnclosedField field(*all.scene.surfaces[0].field);
    const EnclosedField::Frame frame = field.at(all.now.surfaces[0], 2);
    std::vector<FirstRoot> roots(all.tubes.size());
    frame.finder({.evaluations = 4000}).find(all.tubes, roots);
    int hits = 0, misses = 0, undecided = 0, undecided_of_all = 0;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        SCOPED_TRACE(testing::Message() << "ray " << k);
        const FirstRoot &mine = roots[k], &theirs = all.roots[k];
        undecided += mine.answer == Answer::undecided || mine.answer == Answer::touching;
        undecided_of_all += theirs.answer == Answer::undecided || theirs.answer == Answer::touching;
        hits += mine.answer == Answer::hit;
        misses += mine.answer == Answer::miss && all.tubes[k].near <= all.tubes[k].far;
        const bool both = mine.answer <= Answer::hit && theirs.answer <= Answer::hit;
        if (!both) continue;
        EXPECT_EQ(mine.answer, theirs.answer);
        if (mine.answer != Answer::hit) continue;
        EXPECT_LE(mine.low, theirs.high);
        EXPECT_GE(mine.high, theirs.low);
    }
    // The ratio has no bound at the borders of its domain, which each ray to a root crosses.
    const bool has_borders = GetParam().starts_with("sqrt");
    EXPECT_GT(has_borders ? undecided : hits, 50);
    EXPECT_GT(misses, 50);
    EXPECT_LE(undecided, undecided_of_all + 6);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ManyElements,
    testing::Values("0.35 - sum(p, exp(-40*" + distance + "))",
                    "0.3 - sum(p, max(0, 1 - " + distance + "/0.05)^3)",
                    "min(0.3 - sum(p, max(0, 1 - " + distance + "/0.05)^3), z + 0.7)",
                    "sqrt((x - sum(p, cx*max(0, 1 - " + distance + "/0.05)^3)/sum(p, max(0, 1 - " +
                        distance + "/0.05)^3))^2 + y^2) - 0.1"));

// Truth costs what matters at a place, not what there is.
TEST(EnclosedField, OfTenThousandElementsIsAsGood) {
    const std::string text =
        scene_text("0.3 - sum(p, max(0, 1 - " + distance + "/0.002)^3)", 10000);
    const scene::Scene scene = scene_of(text);
    const scene::SceneAt now = scene::at_frame(scene, 1);
    const Truth truth = certify(scene, now, 16, 16);
    const auto counts = truth.counts();
    EXPECT_GT(counts[std::size_t(Answer::hit)], 40);
    EXPECT_EQ(counts[std::size_t(Answer::undecided)], 0);
    for (const FirstRoot& root : truth.roots) {
        const bool has_gradient = root.gradient != std::array<float, 3>{};
        EXPECT_EQ(has_gradient, root.answer == Answer::hit);
    }
}

} // namespace
} // namespace isomotion::roots::field_at_frame_test
