// Timelines of the gallery that were looked at and kept: what is found today is the same.
// Where one changes for a reason it is written anew, and its summary read.
#include <algorithm>

#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/golden.h"
#include "topology/scenes.h"
#include "topology/search/arb_verifier.h"
#include "topology/timeline/expectation.h"
#include "topology/timeline/timeline_file.h"

namespace isomotion::topology {
namespace {

class Golden : public testing::TestWithParam<std::string> {
protected:
    std::filesystem::path file() const { return golden_file(GetParam()); }
};

TEST_P(Golden, IsFoundAgain) {
    const scene::Scene scene = animated(GetParam());
    const Expectation expectation = read_expectation(file(), scene.timeline.fps);
    TimelineRecord found{{}, analyse(scene)};
    found.header = header_of(scene, found.timeline.range);
    const Check same = check(expectation, found);
    // Balls prove events of smooth formulas alone; the torus has its own on a cone.
    EXPECT_EQ(std::ranges::all_of(found.timeline.events, &Event::is_proved_again),
              GetParam() != "torus");
    const TimelineRecord golden = std::get<TimelineRecord>(expectation);
    EXPECT_EQ(same.outcome(), golden.timeline.is_complete() ? Outcome::passes : Outcome::incomplete)
        << text(same, file().string());
    EXPECT_EQ(found.header.fingerprint, golden.header.fingerprint);

    // The first, the middle and the last that a claim can be made of.
    std::vector<std::size_t> told;
    for (std::size_t k = 0; k < golden.timeline.events.size(); ++k) {
        const Event& event = golden.timeline.events[k];
        if (event.is_proved && event.kind != Kind::unknown && event.kind != Kind::none)
            told.push_back(k);
    }
    if (told.empty()) return;
    for (std::size_t k : {told.front(), told[told.size() / 2], told.back()}) {
        TimelineRecord moved = golden;
        Event& event = moved.timeline.events[k];
        event.time = event.time + formula::Interval(1e-6);
        std::ranges::sort(moved.timeline.events, {}, [](const Event& e) { return e.time.lo; });
        EXPECT_EQ(check(moved, found).outcome(), Outcome::differs) << "event " << k;
    }
}

// What is kept, not what is found today.
TEST_P(Golden, IsProvedAgainInBalls) {
    const scene::Scene scene = animated(GetParam());
    Timeline timeline = read_timeline(file()).timeline;
    EXPECT_FALSE(timeline.events.empty());
    if (GetParam() == "torus") return; // its events are on a cone
    const ArbVerifier proof(scene, solid_side(scene), timeline.range);
    for (const Event& event : timeline.events) {
        EXPECT_TRUE(event.is_proved_again);
        EXPECT_EQ(proof.verify(event), ArbVerifier::Answer::holds) << event.time.lo;
    }
}

INSTANTIATE_TEST_SUITE_P(Gallery, Golden, testing::ValuesIn(golden_names()),
                         [](const auto& name) { return name.param; });

} // namespace
} // namespace isomotion::topology
