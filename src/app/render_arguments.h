// What is asked of `render`, and how its words become settings.
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
    std::string scene, output, frames, size, method, backend = "auto", channels;
    std::vector<std::string> movies;
    std::string stage = "fragment";
    std::string step, audit = "auto";
    std::vector<std::string> settings;
    std::optional<double> max_wrong; // ppm
    int bits = 8;
    bool resume = false, quiet = false, certify = false;
    scene::Reach reach = scene::Reach::own_folder;
};

// The options by which `render` and `submit` are asked for a sequence: which frames of what go
// where (add_sequence_options), and all that decides their pixels (add_picture_options, which
// returns them).
void add_sequence_options(CLI::App& command, RenderArguments& arguments);
std::vector<CLI::Option*> add_picture_options(CLI::App& command, RenderArguments& arguments);

// What is meant where -o names a movie: the movie, of frames in files beside it.
RenderArguments with_movie_apart(RenderArguments arguments);

// Each of these throws std::invalid_argument with a message that names the option as it was
// written, not the key of the scene file that it stands for.

// The scene's keys that the options set, --set first.
std::vector<scene::Override> overrides(const RenderArguments& arguments);

// Throws where --frames names some that the scene doesn't have.
void expect_frames_of(std::span<const int> frames, const scene::Scene& scene);

// What renders the frames asked for, by default all of the scene, to out/SCENE.####.png if no other
// output is named. Everything is refused that `render` would refuse before it draws.
sequence::Exporter exporter_of(const RenderArguments& arguments);

} // namespace isomotion::app
