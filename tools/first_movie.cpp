// Draws an animation's poster, its frames and their movie by the library alone: what tools/demo
// shows while the rest of the program is still being built.
//
//     first_movie ANIMATION FOLDER [KEY=VALUE ...]
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include <isomotion/isomotion.h>

namespace {

// "name.0001.png"
std::string file_of(const std::string& name, int frame) {
    std::string number = std::to_string(frame);
    number.insert(0, 4 - std::min<std::size_t>(4, number.size()), '0');
    return name + "." + number + ".png";
}

} // namespace

int main(int count, char** words) try {
    if (count < 3) {
        std::cerr << "usage: first_movie ANIMATION FOLDER [KEY=VALUE ...]\n";
        return 2;
    }
    const std::string name = words[1];
    const std::filesystem::path folder = words[2];
    const auto scene = isomotion::Scene::load(name, {words + 3, words + count});
    isomotion::Device device;
    isomotion::Renderer renderer(device, scene);
    std::filesystem::create_directories(folder);
    // Each frame is left as a file, too.
    const auto draw = [&](int frame, const std::string& file) {
        isomotion::Picture picture = renderer.draw(frame);
        picture.write(folder / file);
        return picture;
    };

    const std::string poster = name + "_poster.png";
    draw(scene.poster(), poster);
    std::cout << "one picture: " << (folder / poster).string() << std::endl;

    const int frames = scene.frames();
    int told = 0;
    const auto next = [&](int k) {
        const int tenths = 10 * k / frames;
        if (tenths > std::exchange(told, tenths))
            std::cout << "  frame " << k << " of " << frames << std::endl;
        return draw(k + 1, file_of(name, k + 1));
    };
    const std::filesystem::path movie = folder / (name + ".mp4");
    isomotion::write_movie(movie, scene, frames, next);
    std::cout << "the movie: " << movie.string() << std::endl;
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
