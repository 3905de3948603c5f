// Exports three frames of a scene and their manifest, then once more: nothing is left to draw.
#include <iostream>
#include <utility>

#include <isomotion/scene.h>
#include <isomotion/sequence.h>

using namespace isomotion;

int main(int count, char** words) try {
    sequence::ExportOptions options;
    options.output = "out/meeting.####.png";
    options.frames = {1, 31, 61};
    options.resume = true;
    sequence::Exporter exporter(scene::load(count > 1 ? words[1] : "meeting.toml"), options);

    const auto context = gpu::Context::create();
    sequence::ExportWatcher watcher;
    watcher.warn = [](const std::string& text) { std::cerr << text << '\n'; };
    int begun = -1;
    watcher.progress = [&](const sequence::ExportProgress& now) {
        if (now.done != std::exchange(begun, now.done)) std::cout << now.file.string() << '\n';
    };
    for (int run = 1; run <= 2; ++run) {
        const sequence::ExportTotals totals = exporter.export_frames(*context, watcher);
        std::cout << "run " << run << ": " << totals.drawn << " drawn\n";
    }
    const auto found = sequence::verify("out/meeting.manifest", {.pixels = true});
    std::cout << (found.is_whole() ? "whole\n" : "not whole\n");
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
