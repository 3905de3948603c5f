// The arguments of `render`, and their conversion to settings.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/reading/load.h"
#include "scene/scene.h"
#include "sequence/exporter.h"

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
    scene::Reach reach = scene::Reach::own_folder;
};

// The options of `render` and `submit` for a sequence: scene, frames and output
// (add_sequence_options), and everything that determines their pixels (add_picture_options, which
// returns these options).
void add_sequence_options(CLI::App& command, RenderArguments& arguments);
std::vector<CLI::Option*> add_picture_options(CLI::App& command, RenderArguments& arguments);

// The arguments for an -o that names a movie: the movie, made of frames in files beside it.
RenderArguments with_movie_apart(RenderArguments arguments);

// Each of these throws std::invalid_argument. The message names the option as it was written, not
// the key of the scene file that it sets.

// The scene's keys that the options set, --set first.
std::vector<scene::Override> overrides(const RenderArguments& arguments);

// Throws if --frames names frames that the scene doesn't have.
void expect_frames_of(std::span<const int> frames, const scene::Scene& scene);

// An exporter for the requested frames, by default all of the scene, to out/SCENE.####.png if no
// other output is named. Refuses everything that `render` would refuse before it draws.
sequence::Exporter exporter_of(const RenderArguments& arguments);

} // namespace isomotion::app
