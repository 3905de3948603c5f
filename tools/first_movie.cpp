// Draws an animation's poster, its frames and their movie by the libraries alone: what tools/demo
// shows while the rest of the program is still being built.
//
//     first_movie ANIMATION FOLDER [KEY=VALUE ...]
#include <filesystem>
#include <iostream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/file.h"
#include "image/encode.h"
#include "render/exposure.h"
#include "scene/reading/load.h"
#include "sequence/movies/movie.h"

namespace {

using namespace isomotion;

// One frame, which is left as a file, too.
image::Frame draw(render::Renderer& renderer, const scene::Scene& scene, int frame,
                  const std::filesystem::path& file) {
    image::Frame picture = render::expose(renderer, scene, frame).frame;
    base::write_whole(file, image::encode(picture, image::Format::png8));
    return picture;
}

} // namespace

int main(int count, char** words) try {
    if (count < 3) {
        std::cerr << "usage: first_movie ANIMATION FOLDER [KEY=VALUE ...]\n";
        return 2;
    }
    const std::string name = words[1];
    const std::filesystem::path folder = words[2];
    std::vector<scene::Override> overrides;
    for (int k = 3; k < count; ++k) overrides.emplace_back(words[k]);
    const scene::Scene scene = scene::load(name, overrides);
    const auto context = gpu::Context::create();
    render::RenderOptions options;
    options.width = scene.output.width;
    options.height = scene.output.height;
    options.stage = render::StageChoice::automatic;
    render::Renderer renderer(*context, scene, options);
    std::filesystem::create_directories(folder);

    const auto poster = folder / (name + "_poster.png");
    draw(renderer, scene, scene.output.poster, poster);
    std::cout << "one picture: " << poster.string() << std::endl;

    const int frames = scene.timeline.frames;
    const auto file_of = [&](std::size_t i) {
        return folder / fmt::format("{}.{:04}.png", name, i + 1);
    };
    int told = 0;
    const sequence::MoviePictures pictures{
        std::size_t(frames),
        [&](std::size_t i) {
            const int tenths = 10 * int(i) / frames;
            if (tenths > std::exchange(told, tenths))
                std::cout << "  frame " << i << " of " << frames << std::endl;
            return draw(renderer, scene, int(i) + 1, file_of(i));
        },
        [&](std::size_t i) { return file_of(i).string(); },
    };
    const auto movie = folder / (name + ".mp4");
    const animation::FrameRate rate = scene.timeline.fps;
    sequence::write_movie(movie, pictures, {rate.numerator, rate.denominator});
    std::cout << "the movie: " << movie.string() << std::endl;
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
