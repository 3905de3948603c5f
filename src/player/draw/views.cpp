#include "player/draw/views.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "image/rgba8.h"
#include "image/srgb.h"

namespace isomotion::player {
namespace {

using image::Frame;

std::size_t area(const Frame& frame) {
    return std::size_t(frame.width) * std::size_t(frame.height);
}

const float* samples(const Frame& frame, std::string_view channel) {
    const image::Channel* found = frame.find(channel);
    if (!found) {
        throw image::ImageError(fmt::format("this view needs the channel {}; the picture was drawn "
                                            "without it",
                                            channel));
    }
    return found->samples.data();
}

// A raster of the frame's size, to be filled.
Raster raster_for(const Frame& frame) {
    return {frame.width, frame.height, std::vector<std::uint8_t>(4 * area(frame))};
}

// One opaque colour a pixel.
template<class Colour> Raster raster_of(const Frame& frame, Colour&& colour) {
    Raster raster = raster_for(frame);
    std::uint8_t* out = raster.rgba.data();
    for (std::size_t i = 0, count = area(frame); i < count; ++i, out += 4) {
        const Rgb rgb = colour(i);
        out[0] = rgb[0], out[1] = rgb[1], out[2] = rgb[2], out[3] = 255;
    }
    return raster;
}

Rgb mixed(const Rgb& from, const Rgb& to, double part) {
    Rgb rgb;
    for (std::size_t k = 0; k < 3; ++k) {
        rgb[k] = std::uint8_t(from[k] + part * (double(to[k]) - from[k]) + 0.5);
    }
    return rgb;
}

struct Extent {
    double least = 0, most = 0;
};

// Widens the extent to the finite depths.
void include(std::optional<Extent>& extent, const float* depths, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double z = double(depths[i]);
        if (!std::isfinite(z)) continue;
        if (!extent) extent = Extent{z, z};
        extent->least = std::min(extent->least, z);
        extent->most = std::max(extent->most, z);
    }
}

// What a channel of verdicts holds; anything else than a verdict is none.
std::optional<render::Verdict> verdict_of(float number) {
    if (!(0 <= number && number < float(render::verdict_names.size()))) return std::nullopt;
    const int verdict = int(number);
    if (float(verdict) != number) return std::nullopt;
    return render::Verdict(verdict);
}

enum class Ray { hit, miss, unsettled };
Ray ray_of(float number) {
    const auto verdict = verdict_of(number);
    if (verdict == render::Verdict::hit || verdict == render::Verdict::zero_gradient) {
        return Ray::hit;
    }
    return verdict == render::Verdict::miss ? Ray::miss : Ray::unsettled;
}

// 0 where depths agree, 1 where they are as far apart as depths can be.
double apartness(double part) {
    return std::clamp(1 - std::log10(part) / std::log10(depth_agrees), 0.0, 1.0);
}

} // namespace

std::vector<shader::Channel> channels_of(View view) {
    using shader::Channel;
    switch (view) {
    case View::shaded:
        return {};
    case View::depth:
        return {Channel::depth};
    case View::normal:
        return {Channel::normal};
    case View::evaluations:
        return {Channel::evaluations};
    case View::verdicts:
        return {Channel::verdict};
    case View::difference:
        return {Channel::depth, Channel::verdict};
    }
    return {};
}

Raster shaded(const Frame& frame) { return {frame.width, frame.height, image::rgba8(frame)}; }

Raster depth(const Frame& frame) {
    const float* depths = samples(frame, "Z");
    std::optional<Extent> extent;
    include(extent, depths, area(frame));
    const double range = extent ? extent->most - extent->least : 0;
    const double per_unit = range > 0 ? (255 - far_grey) / range : 0;
    return raster_of(frame, [&](std::size_t i) {
        const double z = double(depths[i]);
        if (std::isnan(z)) return no_number;
        if (std::isinf(z) || !extent) return nothing;
        const double darker = std::clamp((z - extent->least) * per_unit, 0.0, 255.0 - far_grey);
        const auto grey = std::uint8_t(255.5 - darker);
        return Rgb{grey, grey, grey};
    });
}

Raster normals(const Frame& frame) {
    const float* components[] = {samples(frame, "N.X"), samples(frame, "N.Y"),
                                 samples(frame, "N.Z")};
    return raster_of(frame, [&](std::size_t i) {
        Rgb rgb;
        bool any = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const float n = components[k][i];
            if (!std::isfinite(n)) return no_number;
            any = any || n != 0;
            rgb[k] = image::quantised<std::uint8_t>(0.5f + 0.5f * n);
        }
        return any ? rgb : nothing;
    });
}

double heat_end(const Frame& frame) {
    const float* counts = samples(frame, "evaluations");
    std::vector<float> sorted;
    for (std::size_t i = 0; i < area(frame); ++i) {
        if (std::isfinite(counts[i])) sorted.push_back(counts[i]);
    }
    if (sorted.empty()) return 1;
    const auto rank = sorted.begin() + std::ptrdiff_t(0.99 * double(sorted.size() - 1));
    std::nth_element(sorted.begin(), rank, sorted.end());
    for (double decade = 1;; decade *= 10) {
        for (const int step : {1, 2, 5}) {
            if (step * decade >= double(*rank)) return step * decade;
        }
    }
}

Rgb heat(double u) {
    // The line through OKLab that shaders/effects/color_map.glsl draws, and the way from there to
    // linear sRGB (Ottosson 2020).
    const auto along = [&](double from, double to) {
        return from + std::clamp(u, 0.0, 1.0) * (to - from);
    };
    const double lightness = along(0.32, 0.93), a = along(-0.012, -0.055), b = along(-0.13, 0.15);
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    const double linear[] = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                             -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                             -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
    Rgb rgb;
    for (std::size_t k = 0; k < 3; ++k) rgb[k] = image::srgb8().code(float(linear[k]));
    return rgb;
}

Raster evaluations(const Frame& frame, double end) {
    const float* counts = samples(frame, "evaluations");
    if (!(end > 0)) end = heat_end(frame);
    std::array<Rgb, 1024> colours; // finer than what 8 bits tell apart
    for (std::size_t k = 0; k < colours.size(); ++k) {
        colours[k] = heat(double(k) / double(colours.size() - 1));
    }
    return raster_of(frame, [&](std::size_t i) {
        const double u = double(counts[i]) / end;
        if (std::isnan(u)) return no_number;
        return colours[std::size_t(std::clamp(u, 0.0, 1.0) * double(colours.size() - 1) + 0.5)];
    });
}

const std::array<VerdictColour, 5>& verdict_colours() {
    using render::Verdict;
    static const std::array<VerdictColour, 5> colours{{
        {Verdict::miss, {40, 40, 40}},
        {Verdict::hit, {176, 190, 176}},
        {Verdict::step_limit, {255, 231, 0}},
        {Verdict::nan, {255, 0, 255}},
        {Verdict::zero_gradient, {64, 132, 255}},
    }};
    return colours;
}

Raster verdicts(const Frame& frame) {
    const float* numbers = samples(frame, "verdict");
    const auto& colours = verdict_colours();
    return raster_of(frame, [&](std::size_t i) {
        const auto verdict = verdict_of(numbers[i]);
        return verdict ? colours[std::size_t(*verdict)].colour : no_verdict;
    });
}

Difference difference(const Frame& first, const Frame& second) {
    if (first.width != second.width || first.height != second.height) {
        throw image::ImageError(fmt::format("pictures of {}x{} and {}x{} pixels cannot be compared",
                                            first.width, first.height, second.width,
                                            second.height));
    }
    const float *verdict1 = samples(first, "verdict"), *verdict2 = samples(second, "verdict");
    const float *depth1 = samples(first, "Z"), *depth2 = samples(second, "Z");
    std::optional<Extent> extent;
    include(extent, depth1, area(first));
    include(extent, depth2, area(second));
    const double range = extent ? extent->most - extent->least : 0;

    Difference d;
    d.raster = raster_of(first, [&](std::size_t i) {
        const Ray a = ray_of(verdict1[i]), b = ray_of(verdict2[i]);
        const double apart = std::abs(double(depth1[i]) - double(depth2[i]));
        if (a == Ray::unsettled || b == Ray::unsettled ||
            (a == Ray::hit && b == Ray::hit && !std::isfinite(apart))) {
            ++d.other;
            return other_pair;
        }
        if (a != b) {
            ++(a == Ray::hit ? d.only_first : d.only_second);
            return a == Ray::hit ? first_alone : second_alone;
        }
        if (a == Ray::miss) {
            ++d.both_miss;
            return agree_miss;
        }
        ++d.both_hit;
        const double part = apart > 0 ? apart / range : 0;
        d.farthest_apart = std::max(d.farthest_apart, part);
        if (part <= depth_agrees) return agree_hit;
        ++d.apart;
        return mixed(agree_hit, far_apart, apartness(part));
    });
    return d;
}

Raster shown(View view, const Frame& frame) {
    switch (view) {
    case View::shaded:
        return shaded(frame);
    case View::depth:
        return depth(frame);
    case View::normal:
        return normals(frame);
    case View::evaluations:
        return evaluations(frame);
    case View::verdicts:
        return verdicts(frame);
    case View::difference:
        break;
    }
    throw image::ImageError("a difference is of two pictures");
}

} // namespace isomotion::player
