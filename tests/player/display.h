// A display of our own, where nobody looks: Xvfb, driven with xdotool.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "unit/image/places.h"
#include "x_server.h"

namespace isomotion::player {

class Display {
public:
    static constexpr int width = 660, height = 700;

    // None where Xvfb or xdotool is not installed.
    static std::optional<std::string> missing();

    const std::string& name() const { return server_.name(); } // ":7"
    // Red, green and blue of a part of the screen, its top row first.
    std::vector<std::array<std::uint8_t, 3>> screenshot(int left, int top, int width,
                                                        int height) const;
    // xdotool with these words; false if it fails.
    bool drive(std::vector<std::string> words) const;
    void end() { server_.end(); } // as when the machine is shut down

private:
    image::TemporaryFolder folder_; // of the file that the server keeps its screen in
    display::XServer server_{width, height, folder_.path()};
};

} // namespace isomotion::player
