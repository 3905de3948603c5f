// What a second count of the Betti numbers between events says of those that were claimed.
#include "topology/classify/recount.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isomotion::topology {
namespace {

// A tunnel that closes at 1 s and opens at 2 s, or a void that forms and opens.
Timeline story(Kind first, Kind second) {
    Timeline timeline;
    timeline.range = {0, 4};
    timeline.is_proved = timeline.start_is_proved = timeline.end_is_proved = true;
    timeline.start = timeline.end = Betti{1, 1, 0};
    Betti now = *timeline.start;
    for (const Kind kind : {first, second}) {
        Event event;
        event.time = formula::Interval(kind == first ? 1.0 : 2.0);
        event.index = 2;
        event.grows = kind == first;
        event.kind = kind;
        event.kind_proof = "apart";
        event.is_proved = true;
        event.before = now;
        now = now + change(kind);
        event.after = now;
        timeline.events.push_back(event);
    }
    return timeline;
}
const Timeline closes = story(Kind::tunnel_closes, Kind::tunnel_opens);
const Timeline forms = story(Kind::void_forms, Kind::void_opens);

// Of the surface that `closes` tells of.
std::optional<Betti> truth(double time) {
    return time > 1 && time < 2 ? Betti{1, 0, 0} : Betti{1, 1, 0};
}

TEST(Recount, AgreesWithWhatIsSo) {
    std::atomic<int> proofs = 0;
    const Recounting how{.signs = [](double time, int) { return truth(time); },
                         .frame =
                             [&](double time) {
                                 ++proofs;
                                 return truth(time);
                             }};
    EXPECT_EQ(recount(closes, how), (Recount{3, 3}));
    EXPECT_EQ(proofs, 0) << "where grids agree no proof is needed";
}

TEST(Recount, RefusesWhatAProofExcludes) {
    for (const int threads : {1, 3}) {
        const Recounting how{.signs = [](double time, int) { return truth(time); },
                             .frame = truth,
                             .threads = threads};
        EXPECT_THROW(recount(forms, how), Error);
    }
}

// Two events that undo each other were missed, far from the middle of the time between others.
TEST(Recount, LooksBesideTheMiddle) {
    Timeline still;
    still.range = {0, 4};
    still.is_proved = still.start_is_proved = still.end_is_proved = true;
    still.start = still.end = Betti{1, 1, 0};
    const auto filled = [](double time) {
        return std::optional(time > 0.8 && time < 1.2 ? Betti{1, 0, 0} : Betti{1, 1, 0});
    };
    const Recounting how{.signs = [&](double time, int) { return filled(time); }, .frame = filled};
    EXPECT_THROW(recount(still, how), Error);
}

// A time at which all grids tell something else is no agreement, unless it is proved.
TEST(Recount, DoesNotAgreeWhereATimeIsDoubted) {
    const Recounting how{.signs =
                             [](double time, int) {
                                 return time > 0.3 && time < 0.4 ? Betti{5, 0, 0} : *truth(time);
                             },
                         .frame = [](double) { return std::optional<Betti>(); }};
    EXPECT_EQ(recount(closes, how), (Recount{3, 2}));
}

// All grids may be too coarse in the same way.
TEST(Recount, BelievesProofsMoreThanGrids) {
    const Recounting how{.signs = [](double, int) { return Betti{7, 0, 0}; }, .frame = truth};
    EXPECT_EQ(recount(closes, how), (Recount{3, 3}));
}

TEST(Recount, SaysNothingWithoutAProof) {
    const auto none = [](double) { return std::optional<Betti>(); };
    const Recounting alike{.signs = [](double, int) { return Betti{7, 0, 0}; }, .frame = none};
    EXPECT_EQ(recount(closes, alike), (Recount{3, 0}));
    const Recounting unlike{.signs =
                                [](double, int side) {
                                    return Betti{side, 0, 0};
                                },
                            .frame =
                                [](double) {
                                    return Betti{9, 0, 0};
                                }};
    EXPECT_EQ(recount(closes, unlike), (Recount{3, 0})) << "grids that differ ask for no proof";
}

TEST(Recount, AsksFinerGridsWhereCoarseOnesDiffer) {
    const Recounting how{.signs =
                             [](double time, int side) {
                                 return side < 90 ? Betti{2, 0, 0} : truth(time);
                             },
                         .frame = [](double) { return std::optional<Betti>(); }};
    EXPECT_EQ(recount(closes, how), (Recount{3, 3}));
}

TEST(Recount, LeavesOutWhatIsNotClaimed) {
    Timeline doubted = forms;
    doubted.doubts.emplace_back("an event may be missing");
    const Recounting how{.signs = [](double time, int) { return truth(time); }, .frame = truth};
    EXPECT_EQ(recount(doubted, how).spans, 0);
}

TEST(Betti, NothingHasNoTunnels) {
    EXPECT_TRUE((Betti{0, 0, 0}).is_possible());
    EXPECT_TRUE((Betti{1, 3, 2}).is_possible());
    EXPECT_FALSE((Betti{0, 1, 0}).is_possible());
    EXPECT_FALSE((Betti{0, 0, 1}).is_possible());
    EXPECT_FALSE((Betti{1, -1, 0}).is_possible());
}

} // namespace
} // namespace isomotion::topology
