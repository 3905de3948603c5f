#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "animation/frame_range.h"
#include "api/scene/reach.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/new_file.h"
#include "app/render_arguments.h"
#include "base/extension.h"
#include "base/printable.h"
#include "image/environment.h"
#include "probe/sight.h"
#include "render/scene_plan.h"
#include "render/stage.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"
#include "scene/surfaces.h"
#include "shader/assemble.h"
#include "shader/effect.h"
#include "shader/inlined_size.h"

namespace isomotion::app {
namespace {

struct ShowArguments {
    std::string scene;
    std::string frames = "1"; // the first of them is shown
    std::string output;       // a scene file to write, or empty
    bool shader = false;
    std::string pass; // the one to print, or empty
    std::string stage = "fragment";
    std::vector<std::string> settings;
    Reach reach = Reach::own_folder;
};

// Where an array's elements come from, and what columns there are at that time.
void print_samples(const animation::ElementSamples& samples, double time) {
    const animation::SampleSource& source = samples.source();
    const std::size_t k = samples.sample_at(time);
    const std::vector<std::string> names = source.names();
    const auto sample = source.sample(k, std::vector<bool>(source.columns(), true));
    print_result("        from {}\n", base::printable_line(source.origin(k)));
    constexpr std::size_t most = 20;
    for (std::size_t c = 0; c < std::min(names.size(), most); ++c) {
        const std::span<const double> values = sample.columns[c];
        if (values.empty()) continue;
        const auto [least, greatest] = std::ranges::minmax_element(values);
        print_result("        {:<24} {:g} to {:g}\n", base::printable_line(names[c]), *least,
                     *greatest);
    }
    if (names.size() > most) print_result("        and {} columns more\n", names.size() - most);
}

// What the surface says of a parameter's values.
std::string range_text(const scene::Surface& surface, std::size_t track, double value) {
    if (track >= surface.ranges.size()) return "";
    const scene::Range& range = surface.ranges[track];
    if (range.least == -HUGE_VAL && range.most == HUGE_VAL) return "";
    return fmt::format("    {} {:g} to {:g}", range.contains(value) ? "of" : "BEYOND", range.least,
                       range.most);
}

// No driver is asked here, so nothing can be chosen by one.
shader::Stage stage_of(const ShowArguments& arguments) {
    switch (render::parse_stage(arguments.stage)) {
    case render::StageChoice::fragment:
        return shader::Stage::fragment;
    case render::StageChoice::compute:
        return shader::Stage::compute;
    case render::StageChoice::automatic:
        break;
    }
    throw std::invalid_argument("--stage auto is up to the driver, which isomotion doctor asks; "
                                "show one of fragment, compute");
}

// A pass under a heading, its stages one after the other.
void print_pass(const shader::Pass& pass) {
    print_result("// ===== pass '{}', {}\n", pass.name, shader::words(pass.when));
    print_result("// files: {}\n", fmt::join(pass.files, " "));
    if (!pass.vertex.empty()) print_result("// ----- vertex shader\n{}\n", pass.vertex);
    print_result("// ----- {} shader\n{}\n", render::name(pass.stage), pass.text);
}

// Prints the passes that every frame runs, in order; then the names of those that only some frames
// run.
void print_passes(const shader::Passes& passes) {
    for (const shader::Pass& pass : passes.list) {
        if (!shader::is_exceptional(pass.when)) print_pass(pass);
    }
    for (const shader::Pass& pass : passes.list) {
        if (!shader::is_exceptional(pass.when)) continue;
        print_result("// not printed: pass '{}', {} (--pass '{}')\n", pass.name,
                     shader::words(pass.when), pass.name);
    }
}

const shader::Pass& pass_named(const shader::Passes& passes, const std::string& name) {
    std::vector<std::string> names;
    for (const shader::Pass& pass : passes.list) {
        if (pass.name == name) return pass;
        names.push_back(fmt::format("'{}'", pass.name));
    }
    throw std::invalid_argument(fmt::format("--pass '{}': the scene has no such pass; it has {}",
                                            base::printable(name), fmt::join(names, ", ")));
}

// -o: the scene file that the scene is, tried before it is written.
int write_scene(const ShowArguments& arguments) {
    const std::string text =
        scene::scene_file_text(arguments.scene, arguments.settings, api::reach_of(arguments.reach));
    if (base::lower_extension(arguments.output) != ".toml") {
        throw std::invalid_argument(
            fmt::format("-o {}: a scene file's name ends in .toml", arguments.output));
    }
    scene::load_text(text, arguments.output, {}, api::reach_of(arguments.reach));
    write_new_file(arguments.output, text);
    print_result("scene: {}\n", arguments.output);
    return exit_done;
}

// Why no renderer draws it, or nothing.
std::string why_refused(const scene::OneSurface& one, const shader::Passes& passes) {
    const scene::Output& output = one.scene.output;
    const int texture = std::max(output.width, output.height);
    try {
        render::plan_scene(one, passes, output.width, output.height, texture, {});
    } catch (const std::length_error& error) {
        return error.what();
    }
    return {};
}

// What one surface is at a frame; `now` is its own.
void print_surface(const scene::OneSurface& one, const shader::Passes& passes,
                   const scene::OneSurfaceAt& now, int frame) {
    const animation::Values& values = *now.surface.values;
    const scene::Isolation& isolation = one.surface.isolation;
    print_result("formula   {}\n", base::printable(one.surface.field->text));
    print_result("timeline  {} frame{} at {} a second{}\n", one.scene.timeline.frames,
                 one.scene.timeline.frames == 1 ? "" : "s",
                 animation::to_string(one.scene.timeline.fps),
                 one.scene.timeline.loops ? ", a loop" : "");
    print_result("class     {}\n", formula::words(one.surface.measured.smoothness));
    if (isolation.method == scene::Method::hermite) {
        print_result("method    hermite, safety {:g}", isolation.safety);
        const formula::CubicSteps& steps = one.surface.measured.cubic_steps;
        if (steps != formula::CubicSteps{})
            print_result(", steps of {:g} of the usual, the first {:g}", steps.longest,
                         steps.first);
    } else if (!scene::takes_steps(isolation.method)) {
        print_result("method    {}", scene::name(isolation.method));
    } else {
        print_result("method    {}, step {:g}, near {:g}, far {:g}, horizon {:g}, {} bisections",
                     scene::name(isolation.method), isolation.step, isolation.near, isolation.far,
                     isolation.horizon, isolation.bisections);
    }
    const bool looks_out =
        isolation.method == scene::Method::hermite && !one.surface.measured.smoothness.is_smooth();
    print_result("{}{}\n", !passes.beams.empty() ? ", beams" : "",
                 looks_out ? "; by bounds where the formula isn't smooth" : "");
    print_result("frame     {} at t = {:g} s\n", frame, values.time);
    for (std::size_t k = 0; k < values.tracks.size(); ++k) {
        print_result("    {:<28} {:g}{}\n", one.surface.animation.tracks()[k].name,
                     values.tracks[k], range_text(one.surface, k, values.tracks[k]));
    }
    for (std::size_t a = 0; a < values.arrays.size(); ++a) {
        const auto& array = one.surface.animation.arrays()[a];
        print_result("    {:<28} {} elements{}\n", array.name, values.arrays[a].count,
                     shader::array_with_grid(passes) == int(a) ? ", found by place" : "");
        if (array.samples) print_samples(*array.samples, values.time);
    }
    std::vector<std::string_view> called;
    for (const shader::Effect effect : shader::effects(one)) called.push_back(shader::name(effect));
    if (!one.surface.look.name.empty()) {
        print_result("look      {}: sets {}\n", one.surface.look.name,
                     one.surface.look.keys.empty()
                         ? "nothing, as the scene says all itself"
                         : fmt::format("{}", fmt::join(one.surface.look.keys, " ")));
    }
    print_result("effects   {}\n",
                 called.empty() ? "none" : fmt::format("{}", fmt::join(called, " ")));
    if (const auto& paint = one.surface.material.paint; paint && paint->shown) {
        print_result("colormap  {:g} to {:g}, {}\n", paint->shown->least, paint->shown->most,
                     paint->met ? "what the surface shows"
                                : "as no ray of the pictures looked at meets the surface");
    }
    const double size = shader::inlined_size(passes), largest = shader::largest_shaders();
    print_result("compiles  {} passes, {:.0f} operations{}\n", passes.list.size(), size,
                 size > largest ? fmt::format("; more than {:.0f} are not compiled", largest) : "");
    if (const std::string why = why_refused(one, passes); !why.empty())
        print_result("refused   {}\n", why);
    if (passes.tapes)
        print_result(
            "runs      the formula instruction by instruction, as a driver would take long to "
            "compile its {:.0f} operations\n",
            passes.size_compiled);
    const probe::Sight sight = probe::sight(one, now);
    if (one.surface.jumps_are_walls) print_result("jumps     are walls\n");
    const auto& origin = one.surface.field->origin.point;
    if (origin != std::array<double, 3>{})
        print_result("origin    ({:.9g}, {:.9g}, {:.9g}): coordinates are counted from there, as "
                     "floats are too coarse so far out; bounds and transform above, too\n",
                     origin[0], origin[1], origin[2]);
    if (const auto& found = one.surface.found_bounds) {
        const scene::BoundsAt bounds = now.surface.bounds;
        const glm::dvec3 centre = bounds.centre + glm::dvec3(origin[0], origin[1], origin[2]);
        print_result("bounds    found: a ball of radius {:g} about ({:g}, {:g}, {:g}), {}\n",
                     bounds.radius, centre.x, centre.y, centre.z,
                     *found ? "which holds the surface at all frames"
                            : "and the surface may go on beyond it, or there may be none");
    }
    if (sight.values) print_result("nothing   {}\n", probe::why_nothing_is_seen(sight));
    if (sight.cut > 0)
        print_result("bounds    cut the surface open: {:.2g} % of their faces are behind it\n",
                     100 * sight.cut);
    for (const std::string& slip : probe::slips(sight))
        print_result("likely    a slip: {}\n", slip);
    print_result("stage     {}\n", render::name(passes.stage));
    print_result("shaders   {}\n", fmt::join(passes.files(), " "));
}

// Reads the map to its end, as its mistakes may be anywhere.
void expect_map(const scene::Scene& scene) {
    if (!scene.environment) return;
    const image::EnvironmentSink nothing{[](int, int) {}, [](int, std::span<const float>) {}};
    image::read_environment(scene.environment->map, nothing, scene.environment->within,
                            scene.environment->stated_at);
}

int show(const ShowArguments& arguments) {
    if (!arguments.output.empty()) return write_scene(arguments);
    const std::vector<int> frames = animation::parse_frame_range(arguments.frames);
    const scene::Scene scene =
        scene::load(arguments.scene, arguments.settings, api::reach_of(arguments.reach));
    const int frame = frames.front();
    expect_frames_of({&frame, 1}, scene.timeline.frames);
    expect_map(scene);
    const bool lists = !arguments.shader && arguments.pass.empty();
    // Values that have left their range are an error here too.
    std::optional<scene::SceneAt> now;
    if (lists) {
        now = scene::at_frame(scene, frame);
        print_result("{}\n", scene.title);
    }
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        const scene::OneSurface one(scene, k);
        const std::int64_t pixels = std::int64_t(scene.output.width) * scene.output.height;
        const shader::Passes passes =
            shader::assemble(one, {},
                             {.stage = stage_of(arguments),
                              .branches = stage_of(arguments) == shader::Stage::compute,
                              .pixels = pixels});
        if (!one.is_alone()) {
            print_result("{}surface   {}: {} of {}\n", lists ? "\n" : "// ##### ",
                         one.surface.label, k + 1, scene.surfaces.size());
        }
        if (now) {
            print_surface(one, passes, {*now, k}, frame);
        } else if (!arguments.pass.empty()) {
            print_pass(pass_named(passes, arguments.pass));
        } else {
            print_passes(passes);
        }
    }
    return exit_done;
}

} // namespace

void add_show(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<ShowArguments>();
    CLI::App* command = app.add_subcommand(
        "show", "print what a scene is at a frame, its shaders, or its scene file");
    command
        ->add_option(
            "scene", arguments->scene,
            "a scene file (.toml, .jsurf, .pov, .js), the name of an animation, or a formula")
        ->required();
    command->add_option("--frame,--frames", arguments->frames,
                        "frame to show, counted from 1; the first of several (default: 1)");
    command->add_option("-o,--output", arguments->output,
                        "write the scene with its settings as a scene file (.toml) instead");
    command->add_option("--set", arguments->settings, "name=value, as for render")
        ->allow_extra_args(false);
    add_allow_outside(*command, arguments->reach);
    command->add_option("--stage", arguments->stage,
                        "kind of shader that marches the rays: fragment or compute");
    command->add_flag("--shader", arguments->shader,
                      "print the GLSL of every pass that frames run, in order");
    command->add_option("--pass", arguments->pass, "print the GLSL of this pass alone");
    command->callback([arguments, &chosen] { chosen = [arguments] { return show(*arguments); }; });
}

} // namespace isomotion::app
