#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/new_file.h"
#include "base/printable.h"
#include "farm/shell.h"
#include "scene/data_folder.h"
#include "scene/limits.h"

namespace isomotion::app {
namespace fs = std::filesystem;
namespace {

// {0}: where the schema of scene files is; {1}: the scene's title; {2}: its file, {3}: its
// movie's, as words of a shell.
constexpr const char* new_scene = R"toml(#:schema {0}
# A scene of isomotion.
#     isomotion play {2}                    watch it; it is read again when you save it
#     isomotion render {2} --movie {3}
# Every key is in docs/scene-file.md, what a formula may say in docs/formulas.md.

title = "{1}"

[time]
fps = 30
frames = 120       # 4 seconds
loop = true        # the frame after the last would be the first again

[surface]
# The points where both sides are equal. x, y and z are the place; other names are parameters.
formula = "(sqrt(x^2 + y^2) - R)^2 + z^2 = r^2"
bounds = {{ sphere = 1.7 }}   # what is outside is not drawn; without this line bounds are found

[parameters]
# A number, an expression of t (the time in seconds), or keys of time and value.
R = 1
r = "0.35 + 0.15*sin(2*pi*t/4)"
# r = {{ keys = [[0, 0.2], [2, 0.5], [4, 0.2]], ease = "smooth" }}

[camera]
azimuth = "34 + 360*t/4"   # degrees, once around in 4 seconds
elevation = 30
# position = [4, 1, 2]     # instead of azimuth and elevation

[[lights]]
direction = [1, 0.4, 1.2]  # towards the light
color = [0.9, 0.88, 0.85]
shadow = true

[material]
color = [0.72, 0.32, 0.08] # red, green, blue, linear
# model = "ggx"            # from plastic to metal: roughness, metallic

[output]
size = [512, 512]
# samples = 16             # smooth edges
)toml";

int make_scene(const std::string& name) {
    fs::path file = name;
    if (file.extension() != ".toml") file += ".toml";
    const std::string title = file.stem().string();
    if (title.empty() || title.front() == '-' || title.front() == '.' ||
        !base::is_one_printable_line(file.string()) || title.find_first_of("\"\\") != title.npos ||
        title.size() > scene::limits::title_bytes) {
        throw std::invalid_argument(fmt::format("{}: name it by letters, digits, - and _, as ring",
                                                base::printable_line(file.string())));
    }
    write_new_file(
        file, fmt::format(fmt::runtime(new_scene),
                          scene::data_folder().string() + "/animations/scene.schema.json", title,
                          farm::shell_word(file.string()), farm::shell_word(title + ".mp4")));
    print_result("{0}: a scene to start from\n"
                 "    isomotion play {0}      in a window; saved changes show at once\n"
                 "    isomotion render {0}    into files\n",
                 farm::shell_word(file.string()));
    return exit_done;
}

} // namespace

void add_new(CLI::App& app, Action& chosen) {
    const auto name = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("new", "write a scene file with comments to start from");
    command->add_option("name", *name, "name of the scene: NAME.toml is written")->required();
    command->callback([name, &chosen] { chosen = [name] { return make_scene(*name); }; });
}

} // namespace isomotion::app
