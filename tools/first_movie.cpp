// Draws an animation's poster, its frames and their movie by the libraries alone: what tools/demo
// shows while the rest of the program is still being built.
//
//     first_movie ANIMATION FOLDER [KEY=VALUE ...]
#include <iostream>
#include <numeric>
#include <utility>
#include <vector>

#include "scene/reading/load.h"
#include "sequence/exporter.h"

namespace {

using namespace isomotion;

void draw(const scene::Scene& scene, const std::string& output, std::vector<int> frames,
          const std::vector<std::filesystem::path>& movies, gpu::Context& context) {
    sequence::ExportOptions options;
    options.output = output;
    options.frames = std::move(frames);
    options.movies = movies;
    options.audit = 0;
    options.stage = render::StageChoice::automatic;
    const auto count = int(options.frames.size());
    sequence::Exporter exporter(scene, options);
    sequence::ExportWatcher watcher;
    int told = 0;
    watcher.progress = [&](const sequence::ExportProgress& now) {
        const int tenths = 10 * now.done / count;
        if (tenths > std::exchange(told, tenths))
            std::cout << "  frame " << now.done << " of " << count << std::endl;
    };
    exporter.make_folders();
    exporter.export_frames(context, watcher);
    exporter.write_movies();
}

} // namespace

int main(int count, char** words) try {
    if (count < 3) {
        std::cerr << "usage: first_movie ANIMATION FOLDER [KEY=VALUE ...]\n";
        return 2;
    }
    const std::string name = words[1], folder = words[2];
    std::vector<scene::Override> overrides;
    for (int k = 3; k < count; ++k) overrides.emplace_back(words[k]);
    const scene::Scene scene = scene::load(name, overrides);
    const auto context = gpu::Context::create();

    const std::string poster = folder + "/" + name + "_poster.png";
    draw(scene, poster, {scene.output.poster}, {}, *context);
    std::cout << "one picture: " << poster << std::endl;
    std::vector<int> frames(std::size_t(scene.timeline.frames));
    std::iota(frames.begin(), frames.end(), 1);
    const std::string movie = folder + "/" + name + ".mp4";
    draw(scene, folder + "/" + name + ".####.png", frames, {movie}, *context);
    std::cout << "the movie: " << movie << std::endl;
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
