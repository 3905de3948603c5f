// The sentence with which doctor ends.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/speed_probe.h"

namespace isomotion::app {
namespace {

using Json = nlohmann::ordered_json;

Json report(double ms, bool software) {
    return {{"processors", 2},
            {"speed",
             {{"scene", "blobby75"}, {"size", 256}, {"frame_ms", ms}, {"software", software}}}};
}

TEST(Expectation, IsOfTheMachineAndTheTime) {
    EXPECT_EQ(expectation(report(66.7, true)),
              "software renderer, 2 cores: blobby75 renders 15 frames a second at "
              "256x256, and plays "
              "at about 180 pixels");
    EXPECT_EQ(expectation(report(400, true)),
              "software renderer, 2 cores: blobby75 renders 2.5 frames a second "
              "at 256x256, and plays "
              "at about 70 pixels");
    EXPECT_EQ(expectation(report(0.25, false)),
              "graphics card: blobby75 renders 4000 frames a second at 256x256, "
              "and plays at about "
              "2000 pixels or more");
}

TEST(Expectation, IsNotGivenWhereNothingWasMeasured) {
    EXPECT_EQ(expectation(Json{{"processors", 2}}), "");
    EXPECT_EQ(expectation(Json{{"processors", 2}, {"speed", {{"reason", "no"}}}}), "");
}

} // namespace
} // namespace isomotion::app
