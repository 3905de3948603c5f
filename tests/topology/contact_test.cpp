// Contact of two solids against closed forms: when and where they touch and part.
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "scene/surfaces.h"
#include "topology/analyse.h"
#include "topology/moving.h"
#include "topology/solids.h"
#include "topology/subject.h"
#include "topology/told.h"

namespace isomotion::topology {
namespace {

struct Contact {
    std::string first, second; // keys of [[surfaces]]
    std::string rest = "";     // more tables, before them
    int frames = 31;           // 10 a second
    std::array<std::optional<Side>, 2> solids{};

    Timeline timeline(bool is_turned_round = false) const {
        const scene::Scene scene = scene_of(fmt::format(
            "[time]\nfps = 10\nframes = {}\n{}\n[[surfaces]]\n{}\n[[surfaces]]\n{}\n", frames, rest,
            is_turned_round ? second : first, is_turned_round ? first : second));
        AnalyseOptions how;
        how.solids = solids;
        if (is_turned_round) std::swap(how.solids[0], how.solids[1]);
        return analyse_contact({scene, 0}, {scene, 1}, how);
    }
};

// Expects what happens, all of it proved, and so many places of contact at the start and at the
// end.
void expect_told(const Timeline& timeline, int start, const std::vector<Told>& told, int end) {
    SCOPED_TRACE(described(timeline));
    EXPECT_TRUE(timeline.is_complete());
    ASSERT_TRUE(timeline.start && timeline.end);
    EXPECT_EQ(timeline.start->components, start);
    EXPECT_EQ(timeline.end->components, end);
    const std::vector<Event> events = that_change(timeline);
    ASSERT_EQ(events.size(), told.size());
    for (std::size_t k = 0; k < told.size(); ++k) {
        EXPECT_NEAR(middle(events[k].time), told[k].time, 1e-9);
        EXPECT_EQ(events[k].kind, told[k].kind);
        EXPECT_TRUE(events[k].is_proved);
    }
}

void expect_told_both_ways(const Contact& contact, int start, const std::vector<Told>& told,
                           int end) {
    for (const bool is_turned_round : {false, true}) {
        SCOPED_TRACE(is_turned_round ? "turned round" : "");
        expect_told(contact.timeline(is_turned_round), start, told, end);
    }
}

void expect_near(const Event& event, const std::array<double, 3>& place) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(middle(event.where[k]), place[k], 1e-9);
}

const std::string ball = "formula = \"x^2 + y^2 + z^2 - 0.25\"\nbounds = { sphere = 0.7 }\n";

// A block with a hollow, whose bounds touch F < 0: unless told, F > 0 is the solid, the hollow's
// ball.
TEST(Contact, IsOfTheSolidsThatAreChosen) {
    Contact hollow{"formula = \"1 - x^2 - y^2 - z^2\"\nbounds = { box = [[-2, -2, -2], [2, 2, 2]] "
                   "}\n",
                   "formula = \"x^2 + y^2 + z^2 - 0.04\"\nbounds = { sphere = 0.5 }\n"
                   "transform = { translate = [\"0.5*t\", 0.1, 0.05] }\n"};
    // The ball of radius 0.2 leaves the hollow's ball at t = 2.39, and reaches the block at 1.58.
    expect_told_both_ways(hollow, 1, {{2 * std::sqrt(1.44 - 0.0125), Kind::death}}, 0);
    hollow.solids[0] = Side::negative;
    hollow.frames = 21;
    expect_told_both_ways(hollow, 0, {{2 * std::sqrt(0.64 - 0.0125), Kind::birth}}, 1);
    // A ball that its bounds cut is empty for F > 0, and as large as its bounds for F < 0.
    const std::string formula = "formula = \"x^2 + y^2 + z^2 - 1\"\n";
    Contact cut{formula + "bounds = { sphere = 0.9 }\n",
                formula +
                    "bounds = { sphere = 1.5 }\ntransform = { translate = [\"2.5 - t\", 0, 0] "
                    "}\n",
                "", 21};
    expect_told_both_ways(cut, 0, {}, 0);
    cut.solids[0] = Side::negative;
    expect_told_both_ways(cut, 0, {{0.6, Kind::birth}}, 1);
}

TEST(Contact, OfTwoBallsIsWhereTheirCentresAreTheSumOfTheirRadiiApart) {
    const Contact contact{ball, "formula = \"(x - s)^2 + y^2 + z^2 - 0.09\"\n"
                                "bounds = { box = [[-2, -1, -1.1], [2, 1.2, 1]] }\n"
                                "parameters = { s = \"1.5 - t\" }\n"};
    expect_told_both_ways(contact, 0, {{0.7, Kind::birth}, {2.3, Kind::death}}, 0);
    const std::vector<Event> events = that_change(contact.timeline());
    ASSERT_EQ(events.size(), 2U);
    expect_near(events[0], {0.5, 0, 0});
    expect_near(events[1], {-0.5, 0, 0});
}

// The same world as above, whatever the placements; places are the first one's coordinates.
TEST(Contact, GoesByPlacements) {
    for (const char* rotate : {"[0, 0, 90]", "[-180, 270, 0]", "[20, 50, 70]"}) {
        SCOPED_TRACE(rotate);
        const std::string first =
            ball + fmt::format("transform = {{ translate = [10, 0, 0], rotate = {} }}\n", rotate);
        const Contact contact{first,
                              "formula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.4 }\n"
                              "transform = { translate = [\"11.5 - t\", 0, 0], "
                              "rotate = [0, \"10*t\", 30], scale = 0.3 }\n"};
        expect_told_both_ways(contact, 0, {{0.7, Kind::birth}, {2.3, Kind::death}}, 0);
    }
    // Off its coordinates' middle, a ball goes round: it is at (0, 2) after the quarter of a turn.
    const Contact round{ball + "transform = { translate = [0, 2, 0] }\n",
                        "formula = \"(x - 1)^2 + y^2 + z^2 - 0.01\"\nbounds = { sphere = 1.3 }\n"
                        "transform = { rotate = [0, 0, \"45*t\"], scale = 2 }\n"};
    // Both 2 from the axis, 0.7 apart.
    const double angle = 2 * std::asin(0.7 / 4), quarter = std::numbers::pi / 2;
    const auto time = [&](double a) { return a / quarter * 2; };
    expect_told_both_ways(
        round, 0, {{time(quarter - angle), Kind::birth}, {time(quarter + angle), Kind::death}}, 0);
}

TEST(Contact, AboutAThirdAxisTurnsAsPicturesDo) {
    // About x, then y, then z: (0, 1, 0) goes to (0, 0, 1), to (1, 0, 0), to (0, 1, 0).
    const Contact contact{"formula = \"x^2 + (y - 1)^2 + z^2 - 0.25\"\nbounds = { sphere = 1.7 }\n"
                          "transform = { rotate = [90, 90, 90] }\n",
                          ball + "transform = { translate = [0, \"3.5 - t\", 0] }\n"};
    expect_told_both_ways(contact, 0, {{1.5, Kind::birth}}, 1);
    const Contact turned{"formula = \"x^2 + (y - 1)^2 + z^2 - 0.25\"\nbounds = { sphere = 1.7 }\n"
                         "transform = { rotate = [30, 0, 40] }\n",
                         // Where (0, cos 30, sin 30) goes by 40 degrees about z.
                         ball + "transform = { translate = [\"(2.5 - t)*-0.5566703992264195\", "
                                "\"(2.5 - t)*0.6634139481689384\", \"(2.5 - t)*0.5\"] }\n"};
    expect_told_both_ways(turned, 0, {{0.5, Kind::birth}, {2.5, Kind::death}}, 0);
}

// Neither what a formula has beyond its bounds counts, nor is what the bounds cut off closed.
TEST(Contact, IsWithinBothBounds) {
    const std::string falls = ball + "transform = { translate = [AT, 0, \"2 - t\"] }\n";
    const auto at = [&](const char* x) {
        std::string text = falls;
        return text.replace(text.find("AT"), 2, x);
    };
    const std::string block =
        "formula = \"z\"\nbounds = { box = [[-1, -1.1, -1.7], [1, 1.2, 1]] }\n";
    expect_told_both_ways({at("0.1"), block}, 0, {{1.5, Kind::birth}}, 1);
    expect_told_both_ways({at("1.6"), block}, 0, {}, 0);
    // From the side it meets where the bounds cut the block.
    expect_told_both_ways(
        {ball + "transform = { translate = [\"2.5 - t\", 0.1, -0.8] }\n", block, "", 15}, 0,
        {{1, Kind::birth}}, 1);
    // A second ball of the formula, where x is -1, is outside.
    const std::string two = "formula = \"min((x - 1)^2, (x + 1)^2) + y^2 + z^2 - 0.25\"\n"
                            "bounds = { sphere = 0.8, centre = [1, 0, 0] }\n";
    expect_told_both_ways({at("1"), two, "", 32}, 0, {{1, Kind::birth}, {3, Kind::death}}, 0);
    expect_told_both_ways({at("-1"), two, "", 32}, 0, {}, 0);
}

TEST(Contact, IsOfDensitiesToo) {
    const std::string dense = "formula = \"0.25 - x^2 - y^2 - z^2\"\nbounds = { sphere = 0.7 }\n";
    const std::string moves = "transform = { translate = [\"1.5 - t\", 0.01, 0.02] }\n";
    const double gap = std::sqrt(1 - 0.0001 - 0.0004);
    const std::vector<Told> told{{1.5 - gap, Kind::birth}, {1.5 + gap, Kind::death}};
    expect_told_both_ways({dense, dense + moves}, 0, told, 0);
    expect_told_both_ways({dense, ball + moves}, 0, told, 0);
}

// Each has arrays of its own, of one name and of several.
TEST(Contact, IsOfSumsOverElements) {
    const std::string blobs =
        "formula = \"1 - sum(blobs, exp(1 - ((x - cx)^2 + y^2 + z^2)/R^2))\"\n"
        "bounds = { sphere = 0.8 }\n"
        "arrays.blobs = { count = 1, cx = 0, R = 0.5 }\n";
    const std::string least =
        "formula = \"least(far, -(cx - 9)^2*0 + x^2 + y^2 + z^2) - sum(near, R^2)\"\n"
        "bounds = { sphere = 0.7 }\n"
        "arrays = { far = { count = 3, cx = [1, 2, 3] }, near = { count = 1, R = 0.3 } }\n"
        "transform = { translate = [\"1.5 - t\", 0, 0] }\n";
    expect_told_both_ways({blobs, least}, 0, {{0.7, Kind::birth}, {2.3, Kind::death}}, 0);
    std::string other = blobs;
    other.replace(other.find("R = 0.5"), 7, "R = 0.3");
    expect_told_both_ways({blobs, other + "transform = { translate = [\"1.5 - t\", 0, 0] }\n"}, 0,
                          {{0.7, Kind::birth}, {2.3, Kind::death}}, 0);
}

TEST(Contact, MayBeAtSeveralPlaces) {
    // A ball that grows meets two others.
    const Contact contact{"formula = \"min((x - 1)^2, (x + 1.1)^2) + y^2 + z^2 - 0.09\"\n"
                          "bounds = { sphere = 2 }\n",
                          "formula = \"x^2 + y^2 + z^2 - r^2\"\nbounds = { sphere = 3 }\n"
                          "parameters = { r = \"0.1 + 0.5*t\" }\n"};
    expect_told_both_ways(contact, 0, {{1.2, Kind::birth}, {1.4, Kind::birth}}, 2);
}

TEST(Contact, ChangesItsRuleAtKeysOfPlacements) {
    const std::string keys =
        "transform = { translate = { keys = [[0, [2, 0, 0]], [1, [1.2, 0, 0]], "
        "[2, [0.7, 0, 0]], [3, [2, 0, 0]]]";
    expect_told_both_ways({ball, ball + keys + " } }\n"}, 0,
                          {{1.4, Kind::birth}, {2 + 0.3 / 1.3, Kind::death}}, 0);
    // Where one jumps into the other nothing is proved.
    const Timeline jump = Contact{ball, ball + keys + ", ease = \"hold\" } }\n"}.timeline();
    EXPECT_FALSE(jump.is_complete());
    ASSERT_EQ(jump.unresolved.size(), 3U);
    EXPECT_EQ(jump.unresolved[1].time, formula::Interval(2));
    EXPECT_EQ(jump.start, (Betti{0, 0, 0}));
}

TEST(Contact, OfBodiesThatAreInOneAnotherLasts) {
    // At one moment they coincide.
    expect_told_both_ways({ball, "formula = \"x^2 + y^2 + z^2 - r^2\"\nbounds = { sphere = 2 }\n"
                                 "parameters = { r = \"0.1 + 0.4*t\" }\n"},
                          1, {}, 1);
}

TEST(Contact, IsProvedOrRefused) {
    const scene::Scene scene =
        scene_of("[time]\nframes = 2\n[[surfaces]]\n" + ball + "[[surfaces]]\n" + ball);
    AnalyseOptions how;
    how.certify = Certify::off;
    EXPECT_THROW(analyse_contact({scene, 0}, {scene, 1}, how), std::invalid_argument);
}

// Scenes are refused for such a scale at frames only. In between, both bodies shrink to one point.
TEST(Contact, IsNotToldWhereASurfaceIsScaledToAPoint) {
    const std::string scaled =
        "transform = { scale = \"(t - 0.55)^2 - 0.001\" }\n"; // 0 at 0.518 and 0.582
    const std::string apart = "formula = \"(x - 3)^2 + y^2 + z^2 - 0.25\"\n"
                              "bounds = { sphere = 0.7, centre = [3, 0, 0] }\n";
    const Timeline timeline = Contact{ball + scaled, apart + scaled, "", 11}.timeline();
    EXPECT_FALSE(timeline.is_complete()) << described(timeline);
    const Contact grows{ball, apart + "transform = { scale = \"1 + 0.1*t\" }\n"};
    EXPECT_TRUE(grows.timeline().is_complete());
}

TEST(Subject, IsCalledByTheSurfacesThatItIsOf) {
    const std::string ball = "bounds = { sphere = 2 }\nformula = 'x^2 + y^2 + z^2 - 1'\n";
    const auto title = [](const scene::Scene& scene, std::size_t first,
                          std::optional<std::size_t> second = {}) {
        const Subject subject = subject_of(scene, first, second);
        return header_of(subject, {0, 1}, {Side::negative, Side::negative}).title;
    };
    const scene::Scene two = scene_of("title = 'T'\n[[surfaces]]\nname = 'a'\n" + ball +
                                      "[[surfaces]]\nname = 'b'\n" + ball);
    EXPECT_EQ(title(two, 1), "T (b)");
    EXPECT_EQ(title(two, 0, 1), "T (a, b)");
    EXPECT_EQ(title(scene_of("title = 'T'\n[[surfaces]]\nname = 'a'\n" + ball), 0), "T");
}

} // namespace
} // namespace isomotion::topology
