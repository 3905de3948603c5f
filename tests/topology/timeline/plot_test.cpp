// The picture of a timeline as text: well formed, with everything in it and nothing outside.
#include "topology/timeline/plot.h"

#include <regex>

#include <gmock/gmock.h>

#include "topology/timeline/representative_frames.h"
#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::HasSubstr;
using testing::Not;

// Every element closed, in order, and no stray < or &.
void expect_well_formed(const std::string& svg) {
    std::vector<std::string> open;
    const std::regex tag(R"(<(/?)([a-z]+)((?:\s+[a-zA-Z:-]+="[^"<]*")*)\s*(/?)>)");
    std::size_t covered = 0;
    for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it) {
        const std::string between = svg.substr(covered, std::size_t(it->position()) - covered);
        EXPECT_EQ(between.find_first_of("<>"), between.npos) << between;
        covered = std::size_t(it->position() + it->length());
        if ((*it)[1] == "/") {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ(open.back(), (*it)[2]);
            open.pop_back();
        } else if ((*it)[4] != "/") {
            open.push_back((*it)[2]);
        }
    }
    EXPECT_TRUE(open.empty());
    EXPECT_EQ(svg.substr(covered), "\n");
    EXPECT_FALSE(std::regex_search(svg, std::regex("&(?!amp;|lt;|gt;|quot;)")));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(Plot, HasAMarkForEachEvent) {
    const std::string svg = plot_svg(story());
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr("A &lt;made&gt; &amp; timed &quot;scene&quot;"));
    EXPECT_THAT(svg, HasSubstr("complete, all proved"));
    EXPECT_EQ(count(svg, "fill-opacity=\"0.8\""), 4u);
    for (const char* label : {">components<", ">tunnels<", ">merge<", ">tunnel closes<"}) {
        EXPECT_THAT(svg, HasSubstr(label));
    }
    for (const char* label : {">voids<", ">split<", ">unresolved<"}) {
        EXPECT_THAT(svg, Not(HasSubstr(label))) << "nothing of it happens";
    }
}

TEST(Plot, IsWellFormedWhateverIsKnown) {
    std::mt19937_64 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        TimelineRecord record = random_complete(random, int(random() % 40));
        expect_well_formed(plot_svg(record));
        for (Event& event : record.timeline.events) {
            if (random() % 2) event.before.reset();
            if (random() % 2) event.after.reset();
            if (random() % 2) event.kind = Kind::unknown;
            event.is_proved = random() % 2;
        }
        record.timeline.start.reset();
        record.timeline.unresolved.push_back({{-3, 4}, {}, "a <curve>", {}, {}});
        record.timeline.unresolved.push_back({formula::Interval::entire(), {}, "all", {}, {}});
        const std::string svg = plot_svg(record, {{12, "a&b.png"}, {1e9, "c.png"}});
        expect_well_formed(svg);
        EXPECT_THAT(svg, HasSubstr(">unresolved<"));
        EXPECT_THAT(svg, HasSubstr("xlink:href=\"a&amp;b.png\""));
        EXPECT_THAT(svg, HasSubstr("incomplete: "));
    }
    TimelineRecord empty{ten_a_second(), {}};
    expect_well_formed(plot_svg(empty));
}

TEST(Telling, FramesAreInTheMiddleOfQuietSpans) {
    const TimelineRecord record = story();
    EXPECT_THAT(
        representative_frames(record, 5),
        testing::ElementsAre(testing::DoubleNear(5.75, 1e-6), // frames 1 to 10.5
                             testing::DoubleNear(15.375, 1e-6), testing::DoubleNear(30.225, 1e-6),
                             testing::DoubleNear(65.45, 1e-6), testing::DoubleNear(95.85, 1e-6)));
    const auto three = representative_frames(record, 3);
    ASSERT_EQ(three.size(), 3u);
    EXPECT_NEAR(three[1], 65.45, 1e-6) << "the tunnel is what differs longest";
    EXPECT_EQ(representative_frames(record, 0).size(), 0u);
    EXPECT_EQ(representative_frames(record, 1).size(), 1u);
}

TEST(Telling, FramesAscendWithinTheRangeAndAreNoEvents) {
    std::mt19937_64 random(6);
    for (int trial = 0; trial < 20; ++trial) {
        const TimelineRecord record = random_complete(random, int(random() % 300));
        const Steps steps = steps_of(record.timeline);
        const auto frames = representative_frames(record, 8);
        EXPECT_LE(frames.size(), 8u);
        EXPECT_TRUE(std::is_sorted(frames.begin(), frames.end()));
        for (const double frame : frames) EXPECT_TRUE(steps.at((frame - 1) / 10)) << frame;
    }
    TimelineRecord unknown{ten_a_second(), {}};
    unknown.timeline.range = {0, 10};
    EXPECT_EQ(representative_frames(unknown, 4).size(), 4u);
}

} // namespace
} // namespace isomotion::topology
