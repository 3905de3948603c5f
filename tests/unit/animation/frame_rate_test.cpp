#include <cmath>
#include <optional>

#include "animation/timeline.h"
#include "testing.h"

namespace isomotion::animation {
namespace {

TEST(FrameRateText, WholeNumbersFractionsAndDecimals) {
    const std::pair<const char*, FrameRate> cases[] = {
        {"30", {30, 1}},
        {"1", {1, 1}},
        {"30000/1001", {30000, 1001}},
        {"24000/1001", {24000, 1001}},
        {"60/2", {30, 1}},
        {"1/4", {1, 4}},
        {"23.976", {2997, 125}},
        {"29.97", {2997, 100}},
        {"12.5", {25, 2}},
        {"0.1", {1, 10}},
        {"30.0", {30, 1}},
        {"30.", {30, 1}},
        {".5", {1, 2}},

        {"23.976023976", {2'997'002'997, 125'000'000}},
        {"1000000000000000", {1'000'000'000'000'000, 1}},
        {"1/1000000000", {1, 1'000'000'000}},
    };
    for (const auto& [text, rate] : cases) {
        const auto parsed = parse_frame_rate(text);
        ASSERT_TRUE(parsed) << text;
        EXPECT_EQ(*parsed, rate) << text << " is " << to_string(*parsed);
    }
}

TEST(FrameRateText, RefusesWhatIsNoPositiveNumber) {
    for (const char* text :
         {"",     "0",    "0.0",   "0/1",   "-30",   "-1/2", "1/-2", "-1/-2", "1/0", "abc", "30fps",
          "30/",  "/30",  "1/2/3", "1.5/2", "2/1.5", " 30",  "30 ",  "+30",   "1e3", ".",   "/",
          "1..5", "1.-5", "0x10",  "nan",   "inf",   "-0.5", "1,5",  "1.2.3", "1/ 2"}) {
        EXPECT_EQ(parse_frame_rate(text), std::nullopt) << "'" << text << "'";
    }
}

TEST(FrameRateText, RefusesNumbersTooLargeToKeepTimesExact) {
    for (const char* text :
         {"1000000000000001", "1/1000000001", "99999999999999999999", "1/99999999999999999999",
          "0.0000000001", "9223372036854775807", "9223372036.854775808"}) {
        EXPECT_EQ(parse_frame_rate(text), std::nullopt) << text;
    }
}

TEST(FrameRateText, IsReadBackFromWhatIsWritten) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const auto number = [&] { return 1 + random.below(1'000'000'000); };
        const int numerator = number(), denominator = number();
        const auto rate =
            parse_frame_rate(std::to_string(numerator) + "/" + std::to_string(denominator));
        ASSERT_TRUE(rate);
        EXPECT_EQ(rate->numerator * denominator, rate->denominator * numerator);
        EXPECT_EQ(parse_frame_rate(to_string(*rate)), rate);
    }
    EXPECT_EQ(to_string({30, 1}), "30");
    EXPECT_EQ(to_string({30000, 1001}), "30000/1001");
}

} // namespace
} // namespace isomotion::animation
