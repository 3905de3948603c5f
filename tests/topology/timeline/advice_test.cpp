// Each reason of an incomplete timeline has its advice, and none is given without a reason.
#include "topology/timeline/advice.h"

#include <gmock/gmock.h>

#include "topology/timeline/unresolved_groups.h"
#include "topology/timeline/words.h"
#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::AllOf, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty, testing::SizeIs;

Timeline with_unresolved(std::vector<const char*> reasons) {
    Timeline timeline = story().timeline;
    for (const char* why : reasons) timeline.unresolved.push_back({{4.9, 5.1}, {}, why, {}, {}});
    return timeline;
}

// The advice at ten frames a second, as the timelines made by hand have it: frames 1 to 101.
std::vector<std::string> told(const Timeline& timeline) { return advice(timeline, {10, 1}); }

Unresolved between_frames(double from, double to, const char* why = unresolved::degenerate) {
    return {{(from - 1) / 10, (to - 1) / 10}, {}, why, {}, {}};
}

TEST(Advice, IsNoneForWhatIsComplete) { EXPECT_THAT(told(story().timeline), IsEmpty()); }

TEST(Advice, IsOneSentenceForEachReason) {
    const std::vector<const char*> reasons{
        unresolved::degenerate,    unresolved::kink,          unresolved::kinks_meet,
        unresolved::on_edge,       unresolved::index,         unresolved::touches_edge,
        unresolved::rule_changes,  unresolved::rests,         unresolved::turns,
        unresolved::jumps,         unresolved::no_bounds,     unresolved::along_curve,
        unresolved::along_surface, unresolved::lasting_point, unresolved::lasting_curve};
    // One more says beside which frames.
    for (const char* why : reasons)
        EXPECT_THAT(told(with_unresolved({why, why})), SizeIs(2)) << why;
    // Bounds that are touched at an edge or a point have the same.
    EXPECT_THAT(told(with_unresolved(reasons)), SizeIs(reasons.size()));
    EXPECT_THAT(told(with_unresolved({"what no search says"})), SizeIs(1));
}

TEST(Advice, SaysWhatToWriteForAKink) {
    EXPECT_THAT(told(with_unresolved({unresolved::kink})),
                ElementsAre(AllOf(HasSubstr("smoothmin(a, b, k)"), HasSubstr("sqrt(q + k^2)")),
                            HasSubstr("--frames 1-49 and 53-101")));
}

TEST(Advice, IsGivenForKindsAndEnds) {
    Timeline timeline = story().timeline;
    timeline.events[0].kind = Kind::unknown;
    EXPECT_THAT(told(timeline), ElementsAre(HasSubstr("unknown")));
    timeline = story().timeline;
    timeline.start_is_proved = false;
    EXPECT_THAT(told(timeline), ElementsAre(HasSubstr("--certify full")));
    timeline.start.reset();
    EXPECT_THAT(told(timeline), ElementsAre(HasSubstr("another frame")));
    timeline.unresolved.push_back({{0, 0.1}, {}, unresolved::kink, {}, {}});
    EXPECT_THAT(told(timeline), ElementsAre(HasSubstr("smoothmin"), HasSubstr("--frames 3-101")))
        << "the cause";
}

// The spans hold none of what is unresolved, and all whole frames beside it.
TEST(Advice, SpansAreBesideWhatIsUnresolved) {
    const auto spans = [](std::vector<Unresolved> places) {
        Timeline timeline = story().timeline;
        timeline.unresolved = std::move(places);
        const auto all = told(timeline);
        const std::string last = all.empty() ? "" : all.back();
        const auto at = last.find("--frames ");
        return at == last.npos ? "" : last.substr(at + 9);
    };
    EXPECT_EQ(spans({between_frames(1, 1)}), "2-101");
    EXPECT_EQ(spans({between_frames(-7, 1.5)}), "2-101");
    EXPECT_EQ(spans({between_frames(101, 101)}), "1-100");
    EXPECT_EQ(spans({between_frames(40, 40)}), "1-39 and 41-101");
    EXPECT_EQ(spans({between_frames(40.2, 40.7)}), "1-40 and 41-101");
    EXPECT_EQ(spans({between_frames(40.9999999, 41.0000001)}), "1-40 and 42-101");
    EXPECT_EQ(spans({between_frames(19.75, 19.75), between_frames(90.5, 92)}),
              "1-19, 20-90, 93-101");
    EXPECT_EQ(spans({between_frames(2, 3), between_frames(2.5, 100)}), "");
    EXPECT_EQ(spans({between_frames(1, 101), between_frames(40, 40)}), "")
        << "no span is without what lasts";
    std::vector<Unresolved> many;
    for (int k = 1; k < 9; ++k) many.push_back(between_frames(10 * k, 10 * k));
    EXPECT_EQ(spans(many), "1-9, 11-19, 21-29, 31-39, so on");
}

TEST(Advice, PlacesOfOneReasonAndMomentAreOneLine) {
    Timeline timeline = story().timeline;
    timeline.is_proved = false;
    const auto at = [&](double from, double to, double x, const char* why) {
        Unresolved place = between_frames(from, to, why);
        place.where = {near(x), formula::Interval(-1e-9, 1e-9), near(1e-250)};
        timeline.unresolved.push_back(place);
    };
    for (int k = 0; k < 30; ++k) at(20 + 0.1 * k, 20.15 + 0.1 * k, 0.25 * k, unresolved::turns);
    at(60, 60, 0.5, unresolved::turns);
    at(20, 20, 0.5, unresolved::on_edge);
    at(1, 101, 0.75, unresolved::degenerate);
    const auto reasons = gaps(timeline, {10, 1});
    const auto count = [&](const std::string& part) {
        return std::ranges::count_if(
            reasons, [&](const std::string& line) { return line.find(part) != line.npos; });
    };
    EXPECT_EQ(count("unresolved"), 4);
    EXPECT_EQ(count("unresolved at frame 20 to 23.05, at 30 places, near (0, 0, 0), (0.25, 0, 0), "
                    "(0.5, 0, 0), ...: the motion turns"),
              1)
        << reasons[1];
    EXPECT_EQ(count("unresolved at frame 60, near (0.5, 0, 0): the motion turns"), 1);
    EXPECT_EQ(count("unresolved at all times, near (0.75, 0, 0): a critical"), 1);
}

TEST(Advice, WhatMayBe0IsWritten0) {
    using formula::Interval;
    EXPECT_EQ(place_text({Interval(-4e-7, 1e-9), Interval(0), near(1e-250)}), "(0, 0, 0)");
    EXPECT_EQ(place_text({near(1e-7), near(-0.25), near(3)}), "(1e-07, -0.25, 3)");
    EXPECT_EQ(place_text({Interval(-1, 3), near(1e-250), near(-3)}), "(1, 0, -3)");
}

TEST(Advice, EventsAtOnceAreToBeParted) {
    Timeline timeline = story().timeline;
    timeline.events[1].time = timeline.events[0].time;
    timeline.events[0].kind = timeline.events[1].kind = Kind::unknown;
    EXPECT_THAT(told(timeline), ElementsAre(HasSubstr("2 events at frame 10.5 are at one moment")));
    timeline.events[0].kind = timeline.events[1].kind = Kind::merge;
    timeline.events[2].kind = Kind::unknown;
    EXPECT_THAT(told(timeline), ElementsAre(HasSubstr("--frames 40-41")));
    timeline.doubts.emplace_back("interrupted while kinds were proved");
    EXPECT_THAT(told(timeline), ElementsAre(HasSubstr("run to its end")));
}

TEST(Advice, WhatStepsIsToHaveKeys) {
    Timeline timeline = story().timeline;
    timeline.doubts.emplace_back("'floor' steps from value to value; what changes is not seen");
    EXPECT_THAT(told(timeline), ElementsAre(HasSubstr("keys")));
}

// Why an end is not known is told once.
TEST(Advice, AnEndThatIsNotKnownIsOneReason) {
    Timeline timeline = story().timeline;
    timeline.start.reset();
    const auto lines = [&] {
        return std::ranges::count_if(gaps(timeline, {10, 1}), [](const std::string& line) {
            return line.starts_with(start_not_known);
        });
    };
    EXPECT_EQ(lines(), 1);
    timeline.doubts.push_back(std::string(start_not_known) + ": the surface is singular");
    EXPECT_EQ(lines(), 1);
}

} // namespace
} // namespace isomotion::topology
