// One example per command. Help and the manual page begin with them, and tests run them.
#pragma once

#include <string_view>

namespace isomotion::app {

struct Example {
    std::string_view command; // "render"
    std::string_view line;    // "isomotion render blobby75 ..."
    std::string_view what;    // what it does
};

inline constexpr Example examples[] = {
    {"render",
     "isomotion render blobby75 --frames 1-30 --size 256x256 -o out/b.####.png --movie b.mp4",
     "draws the first 30 frames of an animation of the gallery and joins them to a movie"},
    {"submit", "isomotion submit blobby75 --frames 1-30 --size 128x128 -o out/s.####.png",
     "renders on all cores of this machine"},
    {"play", "isomotion play 'x^2 + y^2 + z^2 = 1 + 0.3*sin(9*x + t)'",
     "plays a formula in a window; t is the time in seconds"},
    {"show", "isomotion show blobby75 --frame 31", "says what the scene is at frame 31"},
    {"page", "isomotion page torus -o torus.html",
     "writes a page that plays the torus in a browser"},
    {"new", "isomotion new ring", "writes ring.toml, a scene with comments to start from"},
    {"list", "isomotion list animations", "names the animations that come with the program"},
    {"accuracy", "isomotion accuracy torus --size 64x64",
     "tells how long each method takes, and how many pixels it gets wrong"},
    {"topology", "isomotion topology 'x^2 + y^2 + z^2 = 1 - t' --frames 1-60",
     "proves at which moment the ball is gone"},
    {"verify", "isomotion verify out", "tells whether the sequences in out/ are whole"},
    {"doctor", "isomotion doctor",
     "tells whether OpenGL works here, and what to expect of this machine"},
};

constexpr const Example* example_of(std::string_view command) {
    for (const Example& example : examples) {
        if (example.command == command) return &example;
    }
    return nullptr;
}

} // namespace isomotion::app
