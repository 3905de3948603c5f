// Elements by expressions in place of values: which, with what exceptions, and when that is
// shorter.
#include "page/computed_elements.h"

#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "page/frame_values.h"
#include "scene/reading/load.h"

namespace isomotion::page {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// Balls whose fields are cx, cy, cz, at 9 times from 0 to 1.
WebScene balls(const std::string& fields, int count = 12) {
    return web_scene(scene::load_text(
        fmt::format("[surface]\nformula = 'sum(b, exp(-9*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - "
                    "0.5 - 0.01*(a + k)'\nbounds = {{ sphere = 2 }}\n[time]\nframes = 9\nfps = 8\n"
                    "[parameters]\na = '0.1 + t'\nk = {{ keys = [[0, 0], [1, 1]] }}\n"
                    "[arrays.b]\ncount = {}\n{}",
                    count, fields),
        "page.toml"));
}

std::vector<int> fields_of(const WebScene& web) {
    const FrameValues values = frame_values(web);
    return values[0].computed.at(0) ? values[0].computed[0]->fields : std::vector<int>{};
}

TEST(ComputedElements, AreFieldsThatMoveByExpressionsAlone) {
    EXPECT_THAT(fields_of(balls("cx = 'sin(i + t)'\ncy = 'i/n'\ncz = 'cos(a*i)'\n")),
                ElementsAre(0, 2))
        << "what stands is shorter as it is";
    EXPECT_THAT(fields_of(balls("cx = 'sin(i + t)'\ncy = 'i*k'\ncz = 'cy + t'\n")), ElementsAre(0))
        << "keys are no expression, nor is what follows them";
    EXPECT_THAT(fields_of(balls("cx = 'sin(i + t)'\ncy = '(1 + t)^1.7*i'\ncz = 0\n")),
                ElementsAre(0))
        << "powers differ between browsers";
    EXPECT_THAT(fields_of(balls("cx = 'i'\ncy = 'i/n'\ncz = 0\n")), IsEmpty());
    EXPECT_THAT(fields_of(balls("cx = 'sin(i + t)'\ncy = 0\ncz = 0\n", most_computed)), SizeIs(1));
    EXPECT_THAT(fields_of(balls("cx = 'sin(i + t)'\ncy = 0\ncz = 0\n", most_computed + 1)),
                IsEmpty());
}

// The tables have none of what is worked out; what is kept are the words of the values.
TEST(ComputedElements, KeepWhatIntervalsDoNotTell) {
    const std::string moving =
        "cx = 'sin((pi*t + 2.1) - 2.1)*(i + 1)'\ncy = 'cos(i + t)'\ncz = 0\n";
    const WebScene web = balls(moving);
    const FrameValues values = frame_values(web);
    ASSERT_TRUE(values[0].computed[0]);
    EXPECT_EQ(values[0].arrays[0].moving(), 0u);
    const auto& exceptions = values[0].computed[0]->exceptions;
    // What rounding leaves of pi is some 1e-16, of which no float is certain, at the last of the
    // times; 0 is exact.
    ASSERT_THAT(exceptions, SizeIs(12));
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(exceptions[i].row, 8u);
        const auto value = std::bit_cast<float>(exceptions[i].word);
        EXPECT_TRUE(value != 0 && std::abs(value) < 1e-14) << value;
    }
    // Where nothing is certain, all values are held.
    EXPECT_THAT(fields_of(balls("cx = '(1 + i*t*1e-15) - 1'\ncy = 0\ncz = 0\n")), IsEmpty());
    // What all elements share is none of their fields.
    EXPECT_THAT(fields_of(balls("cx = 't'\ncy = 0\ncz = 0\n")), IsEmpty());
}

TEST(ComputedElements, ArePackedAsCountAndWords) {
    std::vector<std::byte> packed;
    pack({{0}, {{1, 2, 0x3040506}}}, packed);
    EXPECT_THAT(packed, ElementsAre(std::byte(1), std::byte(0), std::byte(0), std::byte(0),
                                    std::byte(1), std::byte(0), std::byte(0), std::byte(0),
                                    std::byte(2), std::byte(0), std::byte(0), std::byte(0),
                                    std::byte(6), std::byte(5), std::byte(4), std::byte(3)));
}

// Expressions come with the tracks that they name, those behind them first.
TEST(ComputedElements, TellTheTracksThatTheyName) {
    const WebScene web = balls("cx = 'sin(i + a)'\ncy = 0\ncz = 0\n");
    const FrameValues values = frame_values(web);
    ASSERT_TRUE(values[0].computed[0]);
    const auto json = json_of(*values[0].computed[0], web.surfaces[0].one.surface, 0);
    ASSERT_THAT(json["tracks"], SizeIs(1));
    EXPECT_EQ(json["tracks"][0][0].get<int>(), *web.surfaces[0].one.surface.animation.find("a"));
    EXPECT_TRUE(json["tracks"][0][1].contains("code"));
}

} // namespace
} // namespace isomotion::page
