// Exports three frames of a scene and their manifest, then once more: nothing is left to draw.
#include <iostream>
#include <utility>

#include <isomotion/isomotion.h>

using namespace isomotion;

int main(int count, char** words) try {
    const Scene scene = Scene::load(count > 1 ? words[1] : "meeting.toml");
    ExportSettings settings;
    settings.output = "out/meeting.####.png";
    settings.frames = {1, 31, 61};
    settings.resume = true;

    Device device;
    int begun = 0;
    ExportWatcher watcher;
    watcher.warn = [](const std::string& text) { std::cerr << text << '\n'; };
    watcher.progress = [&](const ExportProgress& now) {
        if (now.frame != std::exchange(begun, now.frame)) std::cout << now.file.string() << '\n';
    };
    for (int run = 1; run <= 2; ++run) {
        const Exported done = export_frames(device, scene, settings, watcher);
        std::cout << "run " << run << ": " << done.drawn << " drawn\n";
    }
    std::cout << (verify("out/meeting.manifest", true).whole ? "whole\n" : "not whole\n");
    return 0;
} catch (const Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
