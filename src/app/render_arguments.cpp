#include "app/render_arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands.h"
#include "app/open_context.h"
#include "base/extension.h"
#include "base/input_error.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::app {
namespace {

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
    if (width > largest_side || height > largest_side) {
        throw std::invalid_argument(fmt::format(
            "--size {}: a picture has at most {} pixels along each side", text, largest_side));
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

std::string known_methods() { return fmt::format("{}", fmt::join(methods(), ", ")); }

std::string method_key(const std::string& text) {
    if (const auto known = methods(); std::ranges::find(known, text) == known.end()) {
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

std::vector<int> frames_of(const std::string& text, const Scene& scene) {
    if (text == "poster") return {scene.poster()};
    if (text.empty()) return {};
    return frame_numbers(text);
}

} // namespace

void add_sequence_options(CLI::App& command, RenderArguments& a) {
    command
        .add_option(
            "scene", a.scene,
            "a scene file (.toml, .jsurf, .pov, .js), the name of an animation, or a formula")
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

std::vector<std::string> listed(const std::string& text) {
    std::vector<std::string> items;
    std::istringstream stream(text);
    for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
    return items;
}

std::vector<std::string> scene_settings(const RenderArguments& arguments) {
    std::vector<std::string> all = arguments.settings;
    if (arguments.certify) all.emplace_back("isolation.certify=true");
    if (!arguments.method.empty()) all.push_back(method_key(arguments.method));
    if (!arguments.step.empty()) all.push_back(step_key(arguments.step));
    if (!arguments.size.empty()) all.push_back(size_key(arguments.size));
    return all;
}

void expect_surface(const Scene& scene, const std::string& name, std::string_view option) {
    const std::vector<std::string> names = scene.surfaces();
    if (names.size() == 1) {
        throw base::InputError(
            fmt::format("{}: has one surface; leave {} out", scene.title(), option));
    }
    if (std::ranges::find(names, name) != names.end()) return;
    throw base::InputError(fmt::format("{} {}: the scene has no such surface; it has {}", option,
                                       name, fmt::join(names, ", ")));
}

void expect_frames_of(std::span<const int> frames, int last) {
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

Scene scene_of(const RenderArguments& arguments) {
    check_amount("--max-wrong", arguments.max_wrong, wrong_pixels);
    Scene scene = Scene::load(arguments.scene, scene_settings(arguments), arguments.reach);
    check_backend(arguments.backend);
    return scene;
}

ExportSettings export_settings(const RenderArguments& arguments, const Scene& scene) {
    ExportSettings settings;
    settings.output = arguments.output;
    settings.frames = frames_of(arguments.frames, scene);
    settings.part_of = frames_of(arguments.part_of, scene);
    settings.resume = arguments.resume;
    settings.movies.assign(arguments.movies.begin(), arguments.movies.end());
    settings.channels = listed(arguments.channels);
    settings.bits = arguments.bits;
    settings.stage = arguments.stage;
    settings.audit = audit_of(arguments.audit);
    return settings;
}

std::string with_option_named(const std::string& message) {
    constexpr std::string_view output = "output";
    return message.starts_with(output) ? "-o" + message.substr(output.size()) : "--" + message;
}

Exporter exporter_of(const Scene& scene, const ExportSettings& settings,
                     const std::function<void(const std::string&)>& warn) {
    return with_options_named([&] { return Exporter(scene, settings, warn); });
}

} // namespace isomotion::app
