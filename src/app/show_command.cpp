#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "base/printable.h"
#include "render/stage.h"
#include "scene/effect.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"
#include "synthesis/assemble.h"

namespace isomotion::app {
namespace {

struct ShowArguments {
    std::string scene;
    int frame = 1;
    bool shader = false;
    std::string stage = "fragment";
    std::vector<std::string> settings;
    scene::Reach reach = scene::Reach::own_folder;
};

// What the surface says of a parameter's values.
std::string range_text(const scene::Scene& scene, std::size_t track, double value) {
    if (track >= scene.surface.ranges.size()) return "";
    const scene::Range& range = scene.surface.ranges[track];
    if (range.least == -HUGE_VAL && range.most == HUGE_VAL) return "";
    return fmt::format("    {} {:g} to {:g}", range.contains(value) ? "of" : "BEYOND", range.least,
                       range.most);
}

// No driver is asked here, so nothing can be chosen by one.
synthesis::Stage stage_of(const ShowArguments& arguments) {
    switch (render::parse_stage(arguments.stage)) {
    case render::StageChoice::fragment:
        return synthesis::Stage::fragment;
    case render::StageChoice::compute:
        return synthesis::Stage::compute;
    case render::StageChoice::automatic:
        break;
    }
    throw std::invalid_argument("--stage auto is up to the driver, which isomotion doctor asks; "
                                "show one of fragment, compute");
}

int show(const ShowArguments& arguments) {
    const scene::Scene scene = scene::load(arguments.scene, arguments.settings, arguments.reach);
    const synthesis::Shaders shaders = synthesis::assemble(scene, {}, stage_of(arguments));
    if (arguments.shader) {
        for (const std::string* text : {&shaders.march, &shaders.surface, &shaders.mirror,
                                        &shaders.mirror_surface, &shaders.shadow, &shaders.shade}) {
            if (!text->empty()) fmt::print("{}\n", *text);
        }
        return exit_done;
    }
    const animation::Values values = scene.timeline.values(arguments.frame);
    scene::at(scene, values); // values that have left their range are an error here too
    const scene::Isolation& isolation = scene.isolation;
    fmt::print("{}\n", scene.title);
    fmt::print("formula   {}\n", base::printable(scene.surface.field->text));
    fmt::print("timeline  {} frames at {} a second{}\n", scene.timeline.frames,
               animation::to_string(scene.timeline.fps), scene.timeline.loops ? ", a loop" : "");
    if (isolation.method == scene::Method::hermite) {
        fmt::print("method    hermite, safety {:g}", isolation.safety);
    } else if (!scene::takes_steps(isolation.method)) {
        fmt::print("method    {}", scene::name(isolation.method));
    } else {
        fmt::print("method    {}, step {:g}, near {:g}, far {:g}, horizon {:g}, {} bisections",
                   scene::name(isolation.method), isolation.step, isolation.near, isolation.far,
                   isolation.horizon, isolation.bisections);
    }
    fmt::print("{}\n", synthesis::uses_beams(scene) ? ", beams" : "");
    fmt::print("frame     {} at t = {:g} s\n", arguments.frame, values.time);
    for (std::size_t k = 0; k < values.tracks.size(); ++k) {
        fmt::print("    {:<28} {:g}{}\n", scene.timeline.animation.tracks()[k].name,
                   values.tracks[k], range_text(scene, k, values.tracks[k]));
    }
    for (std::size_t a = 0; a < values.arrays.size(); ++a) {
        const auto& array = scene.timeline.animation.arrays()[a];
        fmt::print("    {:<28} {} elements\n", array.name, values.arrays[a].count);
    }
    std::vector<std::string_view> called;
    for (const scene::Effect effect : scene::effects(scene)) called.push_back(scene::name(effect));
    fmt::print("effects   {}\n",
               called.empty() ? "none" : fmt::format("{}", fmt::join(called, " ")));
    fmt::print("stage     {}\n", render::name(shaders.stage));
    fmt::print("shaders   {}\n", fmt::join(shaders.files, " "));
    return exit_done;
}

} // namespace

void add_show(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<ShowArguments>();
    CLI::App* command = app.add_subcommand("show", "what a scene is at a frame, and its shader");
    command->add_option("scene", arguments->scene, "a scene file or the name of an animation")
        ->required();
    command->add_option("--frame", arguments->frame, "frame number, from 1")
        ->check(CLI::Range(1, 10'000'000));
    command->add_option("--set", arguments->settings, "name=value, as for render")
        ->allow_extra_args(false);
    add_allow_outside(*command, arguments->reach);
    command->add_option("--stage", arguments->stage,
                        "shaders that march the rays: fragment or compute");
    command->add_flag("--shader", arguments->shader, "print the assembled GLSL");
    command->callback([arguments, &chosen] { chosen = [arguments] { return show(*arguments); }; });
}

} // namespace isomotion::app
