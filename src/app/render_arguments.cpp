#include "app/render_arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "animation/frame_range.h"
#include "app/commands.h"
#include "base/extension.h"
#include "scene/limits.h"
#include "scene/method.h"
#include "sequence/inputs.h"
#include "sequence/names/sequence_name.h"
#include "shader/channel.h"

namespace isomotion::app {
namespace {

constexpr int most_audited = 1'000'000;

std::string size_key(const std::string& text) {
    int width = 0, height = 0;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, width);
    const bool parted = first.ec == std::errc{} && first.ptr != end && *first.ptr == 'x';
    const auto second = parted ? std::from_chars(first.ptr + 1, end, height) : first;
    if (!parted || second.ec != std::errc{} || second.ptr != end || width < 1 || height < 1) {
        const bool is_one = !parted && first.ec == std::errc{} && first.ptr == end && width > 0;
        throw std::invalid_argument(
            fmt::format("--size {}: write WIDTHxHEIGHT, {}", text,
                        is_one ? fmt::format("{0}x{0}", width) : "1920x1080"));
    }
    constexpr int most = scene::limits::picture_side;
    if (width > most || height > most) {
        throw std::invalid_argument(
            fmt::format("--size {}: a picture has at most {} pixels along each side", text, most));
    }
    return fmt::format("output.size=[{},{}]", width, height);
}

std::string step_key(const std::string& text) {
    double step = 0;
    const char* end = text.data() + text.size();
    const auto [parsed, error] = std::from_chars(text.data(), end, step);
    if (error != std::errc{} || parsed != end || !(step > 0) || !std::isfinite(step)) {
        throw std::invalid_argument(
            fmt::format("--step {}: write a length above 0 in formula coordinates, 0.01", text));
    }
    return fmt::format("isolation.step={}", step);
}

std::string known_methods() {
    std::vector<std::string_view> known;
    for (const auto& entry : scene::method_traits) known.push_back(entry.name);
    return fmt::format("{}", fmt::join(known, ", "));
}

std::string method_key(const std::string& text) {
    if (!scene::parse_method(text)) {
        throw std::invalid_argument(
            fmt::format("--method: there is no method '{}'; known: {}", text, known_methods()));
    }
    return fmt::format("isolation.method=\"{}\"", text);
}

// Rays of each frame; none for as many as are cheap.
std::optional<int> audit_of(const std::string& text) {
    if (text == "auto") return std::nullopt;
    if (text == "off") return 0;
    int rays = 0;
    const char* end = text.data() + text.size();
    const auto [parsed, error] = std::from_chars(text.data(), end, rays);
    if (error != std::errc{} || parsed != end || rays < 1 || rays > most_audited) {
        throw std::invalid_argument(
            fmt::format("--audit {}: write auto, off, or a number of rays of each frame, 1 to {}",
                        text, most_audited));
    }
    return rays;
}

std::vector<int> frames_of(const std::string& text, const scene::Scene& scene) {
    if (text == "poster") return {scene.output.poster};
    if (!text.empty()) return animation::parse_frame_range(text);
    return animation::parse_frame_range(fmt::format("1-{}", scene.timeline.frames));
}

std::string output_of(const RenderArguments& arguments, const scene::Scene& scene) {
    if (!arguments.output.empty()) return arguments.output;
    return fmt::format("out/{}.####.png", sequence::stem_of_frames(scene.file.stem().string()));
}

// The channels in one order, whatever the user's: the order decides shader text and fingerprint.
std::vector<shader::Channel> parse_channels(const std::string& text) {
    std::vector<shader::Channel> channels;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        const std::string part = text.substr(begin, comma - begin);
        const auto channel = shader::parse_channel(part);
        if (!channel) {
            std::vector<std::string_view> known;
            for (const auto& entry : shader::channel_names()) known.push_back(entry.name);
            throw std::invalid_argument(fmt::format(
                "--channels: there is no channel '{}'; known: {}", part, fmt::join(known, ", ")));
        }
        if (std::find(channels.begin(), channels.end(), *channel) == channels.end()) {
            channels.push_back(*channel);
        }
        begin = comma + 1;
    }
    std::sort(channels.begin(), channels.end());
    return channels;
}

} // namespace

void add_sequence_options(CLI::App& command, RenderArguments& a) {
    command
        .add_option("scene", a.scene,
                    "a scene file (.toml, .jsurf, .pov), the name of an animation, or a formula")
        ->required();
    command.add_option(
        "-o,--output", a.output,
        "files to write: out/name.####.png or .exr, where #### is the frame's number; or "
        "a movie, with its frames beside it");
    command.add_option(
        "--frames,--frame", a.frames,
        "frames to render: 1-10, 1-10x2 (every second), 1,3,5-9 or poster (default: all)");
    command
        .add_option(
            "--movie", a.movies,
            "also join the frames to a movie: .mp4, .webm or .gif; may be given several times")
        ->allow_extra_args(false);
    command.add_flag("--resume", a.resume,
                     "keep files that are already what these settings render");
    command.add_flag("--quiet", a.quiet, "print errors and warnings only");
}

std::vector<CLI::Option*> add_picture_options(CLI::App& command, RenderArguments& a) {
    return {
        command.add_option("--size", a.size, "size of the picture, WIDTHxHEIGHT"),
        command
            .add_option(
                "--set", a.settings,
                "set a parameter (r=0.5) or a key of the scene file (camera.fov=30); may be given "
                "several times")
            ->allow_extra_args(false),
        add_allow_outside(command, a.reach),
        command.add_option("--method", a.method,
                           "how roots are found: " + known_methods() +
                               "; isomotion list methods explains them"),
        command.add_option("--step", a.step,
                           "base step of the paper's methods, in formula coordinates"),
        command.add_option(
            "--max-wrong", a.max_wrong,
            "choose the cheapest method and step that get at most so many pixels in a million "
            "wrong, compared with certified truth; exit code 1 if there is none"),
        command.add_option("--backend", a.backend, "OpenGL back end: auto, egl, osmesa or glfw"),
        command.add_option(
            "--stage", a.stage,
            "kind of shader that marches the rays: fragment, compute, or auto, the faster here"),
        command.add_option("--channels", a.channels,
                           "channels of an EXR beside the picture: "
                           "z,n,p,verdict,evaluations,velocity,proof,surface,cap"),
        command.add_flag("--certify", a.certify,
                         "prove by interval arithmetic, pixel by pixel, that hits are first roots "
                         "and that misses have none; print how many are proved"),
        command.add_option("--audit", a.audit,
                           "compare so many random rays of each frame with certified truth: a "
                           "number, off, or auto (as many as are cheap)"),
        command.add_option("--bits", a.bits, "bits of a PNG: 8 or 16")
            ->check(CLI::IsMember({8, 16})),
    };
}

RenderArguments with_movie_apart(RenderArguments arguments) {
    const std::filesystem::path output = arguments.output;
    const std::string extension = base::lower_extension(output);
    if (extension != ".mp4" && extension != ".webm" && extension != ".gif") return arguments;
    arguments.movies.insert(arguments.movies.begin(), arguments.output);
    const std::string stem = sequence::stem_of_frames(output.stem().string());
    arguments.output = (output.parent_path() / (stem + ".####.png")).string();
    return arguments;
}

std::vector<scene::Override> overrides(const RenderArguments& arguments) {
    std::vector<scene::Override> all = arguments.settings;
    if (arguments.certify) all.emplace_back("isolation.certify=true");
    if (!arguments.method.empty()) all.push_back(method_key(arguments.method));
    if (!arguments.step.empty()) all.push_back(step_key(arguments.step));
    if (!arguments.size.empty()) all.push_back(size_key(arguments.size));
    return all;
}

void expect_frames_of(std::span<const int> frames, const scene::Scene& scene) {
    const int last = scene.timeline.frames;
    const auto beyond = std::ranges::find_if(frames, [&](int frame) { return frame > last; });
    if (beyond == frames.end()) return;
    throw std::invalid_argument(
        last == 1 ? fmt::format("--frames {}: the scene has one frame, 1; --set time.frames={} "
                                "gives it more",
                                *beyond, *beyond)
                  : fmt::format("--frames {}: the scene has frames 1 to {}; --set time.frames={} "
                                "gives it more",
                                *beyond, last, *beyond));
}

sequence::Exporter exporter_of(const RenderArguments& arguments) {
    check_amount("--max-wrong", arguments.max_wrong, wrong_pixels);
    scene::Scene scene = scene::load(arguments.scene, overrides(arguments), arguments.reach);
    gpu::parse_backend(arguments.backend);
    sequence::ExportOptions options;
    options.stage = render::parse_stage(arguments.stage);
    options.channels = parse_channels(arguments.channels);
    options.frames = frames_of(arguments.frames, scene);
    if (!arguments.part_of.empty()) options.part_of = frames_of(arguments.part_of, scene);
    options.output = output_of(arguments, scene);
    options.bits = arguments.bits;
    options.audit = audit_of(arguments.audit);
    options.resume = arguments.resume;
    options.movies.assign(arguments.movies.begin(), arguments.movies.end());
    const sequence::Inputs inputs(scene);
    inputs.expect_apart("-o", sequence::SequenceName::parse(options.output));
    for (const std::string& movie : arguments.movies) inputs.expect_apart("--movie", movie);
    try {
        return {std::move(scene), std::move(options)};
    } catch (const sequence::OptionError& error) {
        throw std::invalid_argument(fmt::format("--{}", error.what()));
    }
}

} // namespace isomotion::app
