// Betti numbers frame by frame.
#include "topology/timeline/betti_csv.h"

#include <sstream>

#include <gmock/gmock.h>

#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(BettiCsv, HasALineForEachFrame) {
    const auto lines = lines_of(betti_csv(story()));
    ASSERT_EQ(lines.size(), 102u); // frames 1 to 101
    EXPECT_EQ(lines[0], "frame,b0,b1,b2,surface_b0,surface_b1,surface_b2,proved,to_next_event,"
                        "from_last_event");
    EXPECT_EQ(lines[1], "1,3,0,0,3,0,3,1,9.5,");
    EXPECT_EQ(lines[10], "10,3,0,0,3,0,3,1,0.5,");
    EXPECT_EQ(lines[11], "11,2,0,0,2,0,2,1,9.25,0.5");
    EXPECT_EQ(lines[50], "50,1,1,0,1,2,1,1,40.7,9.8");
    EXPECT_EQ(lines[101], "101,1,0,0,1,0,1,1,,10.3");
}

TEST(BettiCsv, SurfacesAreTheSolids) {
    const auto lines = lines_of(betti_csv(complete({1, 2, 1}, {})));
    EXPECT_EQ(lines[1], "1,1,2,1,2,4,2,1,,");
}

TEST(BettiCsv, AtAnEventNothingIsSaid) {
    const auto lines = lines_of(betti_csv(complete({2, 0, 0}, {event_at(51, Kind::merge)})));
    EXPECT_EQ(lines[50], "50,2,0,0,2,0,2,1,1,");
    EXPECT_EQ(lines[51], "51,,,,,,,0,0,0");
    EXPECT_EQ(lines[52], "52,1,0,0,1,0,1,1,,1");
}

TEST(BettiCsv, FractionalRatesKeepTheirFrames) {
    TimelineRecord record = complete({1, 0, 0}, {});
    record.header.fps = {30000, 1001};
    const animation::Timeline clock{record.header.fps};
    record.timeline.range = {clock.time(17), clock.time(812)};
    const auto lines = lines_of(betti_csv(record));
    ASSERT_EQ(lines.size(), 797u);
    EXPECT_EQ(lines[1], "17,1,0,0,1,0,1,1,,");
    EXPECT_EQ(lines.back(), "812,1,0,0,1,0,1,1,,");
}

TEST(BettiCsv, WhatIsNotProvedSaysSo) {
    TimelineRecord record = story();
    record.timeline.is_proved = false;
    EXPECT_EQ(lines_of(betti_csv(record))[1], "1,3,0,0,3,0,3,0,9.5,");
    record.timeline = {};
    record.timeline.range = {0, 1};
    EXPECT_EQ(lines_of(betti_csv(record))[1], "1,,,,,,,0,,");
}

} // namespace
} // namespace isomotion::topology
