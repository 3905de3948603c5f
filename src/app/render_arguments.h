// The arguments of `render`, and their conversion to settings.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isomotion/isomotion.h"

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace isomotion::app {

struct RenderArguments {
    std::string scene, output, frames, part_of, size, method, backend = "auto", channels;
    std::vector<std::string> movies;
    std::string stage = "fragment";
    std::string step, audit = "auto";
    std::vector<std::string> settings;
    std::optional<double> max_wrong; // ppm
    int bits = 8;
    bool resume = false, quiet = false, certify = false;
    Reach reach = Reach::own_folder;
};

// The options of `render` and `submit` for a sequence: scene, frames and output
// (add_sequence_options), and everything that determines their pixels (add_picture_options, which
// returns these options).
void add_sequence_options(CLI::App& command, RenderArguments& arguments);
std::vector<CLI::Option*> add_picture_options(CLI::App& command, RenderArguments& arguments);

// The arguments for an -o that names a movie: the movie, made of frames in files beside it.
RenderArguments with_movie_apart(RenderArguments arguments);

// The parts of "a,b".
std::vector<std::string> listed(const std::string& text);

// Each of these throws std::invalid_argument. The message names the option as it was written, not
// the key of the scene file that it sets.

// The scene's settings that the options make, --set first.
std::vector<std::string> scene_settings(const RenderArguments& arguments);

// Throws if a scene of several surfaces has none of that name, or if there is but one.
void expect_surface(const Scene& scene, const std::string& name, std::string_view option);

// Throws if --frames names frames after the scene's last.
void expect_frames_of(std::span<const int> frames, int last);

// The scene, and what is to become of it: all of its frames if no others are named. These refuse
// all that `render` refuses before it draws.
Scene scene_of(const RenderArguments& arguments);
ExportSettings export_settings(const RenderArguments& arguments, const Scene& scene);
Exporter exporter_of(const Scene& scene, const ExportSettings& settings,
                     const std::function<void(const std::string&)>& warn = {});

// A message that begins with a setting's name, with the option instead: "--frames: ...".
std::string with_option_named(const std::string& message);

// Does something with settings of the public header, and names options in their mistakes.
template<class Work> decltype(auto) with_options_named(Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const Error& error) {
        if (error.code() != Error::Code::setting) throw;
        throw Error(Error::Code::setting, with_option_named(error.what()));
    }
}

} // namespace isomotion::app
