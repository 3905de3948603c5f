// Pictures of a few pixels, each of them a case.
#include "player/draw/views.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include <fmt/format.h>

#include "base/file.h"
#include "image/decode.h"
#include "image/encode.h"
#include "image/srgb.h"
#include "unit/formula/testing.h"
#include "unit/image/places.h"

namespace isomotion::player {
namespace {

using formula::Random;
using image::Frame;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

// One row.
Frame row(const std::string& channel, const std::vector<float>& samples) {
    return {int(samples.size()), 1, {{channel, samples}}, {}};
}

std::vector<Rgb> colours(const Raster& raster) {
    std::vector<Rgb> found;
    for (std::size_t k = 0; k < raster.rgba.size(); k += 4) {
        EXPECT_EQ(raster.rgba[k + 3], 255) << "opaque";
        found.push_back({raster.rgba[k], raster.rgba[k + 1], raster.rgba[k + 2]});
    }
    return found;
}

Rgb grey(int code) { return {std::uint8_t(code), std::uint8_t(code), std::uint8_t(code)}; }

template<class Call> std::string complaint(Call&& call) {
    try {
        call();
    } catch (const image::ImageError& error) {
        return error.what();
    }
    return "nothing is wrong";
}

// decode() gives light times coverage; the codes that the file holds are the nearest to it. Where
// the coverage is 0 they are lost; shaded() has 0 there.
std::vector<std::uint8_t> codes_in_png(const Frame& frame) {
    const image::TemporaryFolder folder;
    base::write_whole(folder / "a.png", image::encode(frame, image::Format::png8));
    const Frame read = image::decode(folder / "a.png");
    const image::Channel* coverage = read.find("A");
    std::vector<std::uint8_t> codes;
    for (std::size_t i = 0; i < std::size_t(read.width) * std::size_t(read.height); ++i) {
        const float a = coverage ? coverage->samples[i] : 1;
        for (const char* name : {"R", "G", "B"}) {
            const float light = read.find(name)->samples[i];
            codes.push_back(a > 0 ? image::srgb8().code(light / a) : 0);
        }
        codes.push_back(image::quantised<std::uint8_t>(a));
    }
    return codes;
}

TEST(ShadedView, IsByteForByteWhatAPngHolds) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Frame frame{16, 8, {}, {}};
        std::vector<float> coverage;
        for (int i = 0; i < 128; ++i) {
            const int kind = random.below(4);
            coverage.push_back(kind == 0 ? 0 : kind == 1 ? 1 : float(random.in(0.01, 1)));
        }
        const bool is_opaque = seed % 2 == 0;
        if (is_opaque) coverage.assign(128, 1);
        for (const char* name : {"R", "G", "B"}) {
            std::vector<float> samples;
            for (std::size_t i = 0; i < 128; ++i) {
                const int kind = random.below(12);
                samples.push_back(kind == 0   ? nan
                                  : kind == 1 ? infinity
                                  : kind == 2 ? -1
                                              : coverage[i] * float(random.in(0, 1.2)));
            }
            frame.channels.push_back({name, samples});
        }
        if (!is_opaque) frame.channels.push_back({"A", coverage});
        const Raster raster = shaded(frame);
        EXPECT_EQ(raster.width, 16);
        EXPECT_EQ(raster.height, 8);
        EXPECT_EQ(raster.rgba, codes_in_png(frame));
    }
}

TEST(ShadedView, HasEveryCodeThereIs) {
    Frame frame{256, 1, {}, {}};
    std::vector<float> light;
    for (int k = 0; k < 256; ++k) light.push_back(image::srgb8().light(std::uint8_t(k)));
    for (const char* name : {"R", "G", "B"}) frame.channels.push_back({name, light});
    const Raster raster = shaded(frame);
    for (std::size_t k = 0; k < 256; ++k) {
        EXPECT_EQ(raster.rgba[4 * k], k);
        EXPECT_EQ(raster.rgba[4 * k + 3], 255);
    }
}

TEST(DepthView, IsWhiteNearAndDarkFar) {
    const Frame frame = row("Z", {4, infinity, 2, nan, 3, -infinity});
    EXPECT_EQ(colours(depth(frame)),
              (std::vector<Rgb>{grey(far_grey), nothing, grey(255), no_number,
                                grey((255 + far_grey + 1) / 2), nothing}));
}

TEST(DepthView, NeedsNoHits) {
    EXPECT_EQ(colours(depth(row("Z", {infinity, nan}))), (std::vector<Rgb>{nothing, no_number}));
    EXPECT_EQ(colours(depth(row("Z", {5, 5, infinity}))),
              (std::vector<Rgb>{grey(255), grey(255), nothing}));
}

TEST(NormalView, IsTheDirectionAsAColour) {
    Frame frame{6, 1, {}, {}};
    frame.channels = {
        {"N.X", {1, 0, 0, -1, 0, nan}}, {"N.Y", {0, 1, 0, 0, 0, 0}}, {"N.Z", {0, 0, 1, 0, 0, 1}}};
    EXPECT_EQ(
        colours(normals(frame)),
        (std::vector<Rgb>{
            {255, 128, 128}, {128, 255, 128}, {128, 128, 255}, {0, 128, 128}, nothing, no_number}));
}

TEST(HeatMap, GrowsLighterFromBlueToYellow) {
    const auto luminance = [](const Rgb& c) {
        const auto light = [](std::uint8_t code) { return double(image::srgb8().light(code)); };
        return 0.2126 * light(c[0]) + 0.7152 * light(c[1]) + 0.0722 * light(c[2]);
    };
    for (int k = 1; k <= 100; ++k) {
        EXPECT_GT(luminance(heat(k / 100.0)), luminance(heat((k - 1) / 100.0))) << k;
    }
    const Rgb low = heat(0), high = heat(1);
    EXPECT_GT(low[2], low[0] + 50);
    EXPECT_GT(high[0], high[2] + 50);
    EXPECT_GT(high[1], high[2] + 50);
    EXPECT_EQ(heat(-1), low);
    EXPECT_EQ(heat(2), high);
}

// The shader's own numbers: a map that is changed there has to be changed here.
TEST(HeatMap, HasTheEndsOfTheScenesMap) {
    std::ifstream file(ISOMOTION_SOURCE_DIR "/shaders/effects/color_map.glsl");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find("mix(vec3(0.32, -0.012, -0.13), vec3(0.93, -0.055, 0.15), u)"),
              std::string::npos);
    // OKLab back from the colour: within half a code of 8 bits.
    for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Rgb c = heat(u);
        const auto light = [](std::uint8_t code) { return double(image::srgb8().light(code)); };
        const double r = light(c[0]), g = light(c[1]), b = light(c[2]);
        const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
        const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
        const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
        EXPECT_NEAR(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 0.32 + 0.61 * u, 0.004);
        EXPECT_NEAR(1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s, -0.012 - 0.043 * u,
                    0.004);
        EXPECT_NEAR(0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s, -0.13 + 0.28 * u,
                    0.004);
    }
}

TEST(EvaluationsView, IsTheMapFromNothingToItsEnd) {
    EXPECT_EQ(colours(evaluations(row("evaluations", {0, 50, 100, 500, nan}), 100)),
              (std::vector<Rgb>{heat(0), heat(0.5), heat(1), heat(1), no_number}));
}

TEST(EvaluationsView, ItsEndIsRoundAndKnowsOfNoStrays) {
    EXPECT_EQ(heat_end(row("evaluations", {0, 0, 0})), 1);
    EXPECT_EQ(heat_end(row("evaluations", {nan, infinity})), 1);
    EXPECT_EQ(heat_end(row("evaluations", {3, 11, 11})), 20);
    EXPECT_EQ(heat_end(row("evaluations", std::vector<float>(10, 200))), 200);
    EXPECT_EQ(heat_end(row("evaluations", std::vector<float>(10, 201))), 500);
    std::vector<float> few_at_the_limit(1000, 130);
    for (std::size_t k = 0; k < 5; ++k) few_at_the_limit[200 * k] = 100'000;
    EXPECT_EQ(heat_end(row("evaluations", few_at_the_limit)), 200);
    std::vector<float> some_dear(1000, 130);
    for (std::size_t k = 0; k < 20; ++k) some_dear[50 * k] = 700;
    EXPECT_EQ(heat_end(row("evaluations", some_dear)), 1000) << "one in fifty is no stray";
    EXPECT_EQ(evaluations(row("evaluations", {3, 11, 11})),
              evaluations(row("evaluations", {3, 11, 11}), 20));
}

TEST(VerdictView, GivesEachVerdictAColourOfItsOwn) {
    const auto& legend = verdict_colours();
    std::vector<Rgb> expected;
    for (std::size_t k = 0; k < legend.size(); ++k) {
        EXPECT_EQ(std::size_t(legend[k].verdict), k);
        for (std::size_t j = 0; j < k; ++j) EXPECT_NE(legend[j].colour, legend[k].colour);
        EXPECT_NE(legend[k].colour, no_verdict);
        expected.push_back(legend[k].colour);
    }
    for (int k = 0; k < 3; ++k) expected.push_back(no_verdict);
    EXPECT_EQ(colours(verdicts(row("verdict", {0, 1, 2, 3, 4, 5, nan, 0.5f}))), expected);
    // Amber and magenta as the picture has them: linear (1, 0.8, 0) and (1, 0, 1).
    EXPECT_EQ(legend[2].colour, (Rgb{255, image::srgb8().code(0.8f), 0}));
    EXPECT_EQ(legend[3].colour, (Rgb{255, 0, 255}));
}

Frame rays(const std::vector<float>& verdict, const std::vector<float>& depth) {
    Frame frame = row("verdict", verdict);
    frame.channels.push_back({"Z", depth});
    return frame;
}

TEST(DifferenceView, TellsWhoHitsAndHowFarApart) {
    constexpr float far = infinity;
    const Frame a =
        rays({1, 0, 1, 0, 1, 4, 1, 2, 3, 3, 1}, {1, far, 2, far, 2, 3, 1, far, far, far, nan});
    const Frame b =
        rays({1, 0, 0, 1, 4, 1, 1, 1, 3, 0, 1}, {1, far, far, 2, 2, 2, 11, 1, far, far, 1});
    const Difference d = difference(a, b);
    const auto found = colours(d.raster);
    EXPECT_EQ(found[0], agree_hit);
    EXPECT_EQ(found[1], agree_miss);
    EXPECT_EQ(found[2], first_alone);
    EXPECT_EQ(found[3], second_alone);
    EXPECT_EQ(found[4], agree_hit) << "a zero gradient is a hit";
    EXPECT_NE(found[5], agree_hit);
    EXPECT_EQ(found[6], far_apart) << "as far as depths go";
    for (const std::size_t k : {7u, 8u, 9u, 10u}) EXPECT_EQ(found[k], other_pair) << k;
    EXPECT_EQ(d.both_hit, 4);
    EXPECT_EQ(d.both_miss, 1);
    EXPECT_EQ(d.only_first, 1);
    EXPECT_EQ(d.only_second, 1);
    EXPECT_EQ(d.other, 4);
    EXPECT_EQ(d.apart, 2);
    EXPECT_EQ(d.farthest_apart, 1);
}

TEST(DifferenceView, DepthsGoFromGreyToYellowByTheirLogarithm) {
    std::vector<float> first{0, 1}, second{0, 1}, verdicts(2, 1);
    for (int power = -7; power <= -1; ++power) {
        first.push_back(0);
        second.push_back(float(std::pow(10, power)));
        verdicts.push_back(1);
    }
    const Difference d = difference(rays(verdicts, first), rays(verdicts, second));
    const auto found = colours(d.raster);
    EXPECT_EQ(found[2], agree_hit); // 1e-7
    EXPECT_EQ(d.both_hit, 9);
    EXPECT_EQ(d.apart, 5); // 1e-5 to 1e-1
    for (std::size_t k = 4; k < found.size(); ++k) {
        EXPECT_GT(found[k][0], found[k - 1][0]) << k;
        EXPECT_LT(found[k][2], found[k - 1][2]) << k;
    }
    EXPECT_NEAR(found[5][0], 112 + (255 - 112) * 2 / 6.0, 1); // 1e-4 of 1e-6 to 1
}

// Turned round, red is blue; the depths' colours don't change.
TEST(DifferenceView, IsSymmetric) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const auto picture = [&] {
            std::vector<float> verdict, depth;
            for (int k = 0; k < 64; ++k) {
                verdict.push_back(float(random.below(5)));
                depth.push_back(random.below(9) == 0 ? infinity : float(random.in(1, 2)));
            }
            return rays(verdict, depth);
        };
        const Frame a = picture(), b = picture();
        const Difference there = difference(a, b), back = difference(b, a);
        EXPECT_EQ(there.only_first, back.only_second);
        EXPECT_EQ(there.only_second, back.only_first);
        EXPECT_EQ(there.other, back.other);
        EXPECT_EQ(there.farthest_apart, back.farthest_apart);
        EXPECT_EQ(there.both_hit + there.both_miss + there.only_first + there.only_second +
                      there.other,
                  64);
        const auto x = colours(there.raster), y = colours(back.raster);
        for (std::size_t k = 0; k < x.size(); ++k) {
            if (x[k] == first_alone) {
                EXPECT_EQ(y[k], second_alone);
            } else if (x[k] != second_alone) {
                EXPECT_EQ(x[k], y[k]);
            }
        }
        const Difference same = difference(a, a);
        EXPECT_EQ(same.only_first + same.only_second + same.apart, 0);
    }
}

TEST(DifferenceView, OfPicturesWithoutAHitIsQuiet) {
    const Frame none = rays({0, 0}, {infinity, infinity});
    EXPECT_EQ(colours(difference(none, none).raster), (std::vector<Rgb>{agree_miss, agree_miss}));
}

TEST(Views, SayWhatTheyNeed) {
    const Frame colour = image::plain(2, 2, 0.5f, 0.5f, 0.5f);
    const auto& known = shader::channel_names();
    for (const auto& entry : view_names) {
        SCOPED_TRACE(entry.name);
        EXPECT_EQ(name(entry.view), entry.name);
        // With the channels it asks for a view can be shown, without any of them it cannot.
        Frame whole = colour;
        for (const shader::Channel channel : channels_of(entry.view)) {
            for (const std::string_view layer : known[std::size_t(channel)].layers) {
                whole.channels.push_back({std::string(layer), std::vector<float>(4, 1)});
            }
        }
        const auto show = [&](const Frame& frame) {
            if (entry.view == View::difference) {
                difference(frame, frame);
            } else {
                EXPECT_EQ(shown(entry.view, frame).rgba.size(), 16u);
            }
        };
        EXPECT_EQ(complaint([&] { show(whole); }), "nothing is wrong");
        for (std::size_t k = entry.view == View::shaded ? 0 : 3; k < whole.channels.size(); ++k) {
            Frame part = whole;
            part.channels.erase(part.channels.begin() + std::ptrdiff_t(k));
            EXPECT_NE(complaint([&] { show(part); }), "nothing is wrong") << k;
        }
    }
    EXPECT_EQ(complaint([&] { depth(colour); }),
              "this view needs the channel Z; the picture was drawn without it");
    EXPECT_EQ(complaint([&] { shown(View::difference, colour); }),
              "a difference is of two pictures");
    EXPECT_EQ(complaint([&] { difference(colour, image::plain(1, 2, 0, 0, 0)); }),
              "pictures of 2x2 and 1x2 pixels cannot be compared");
}

} // namespace
} // namespace isomotion::player
