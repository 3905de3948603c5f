// A display of our own, where nobody looks: Xvfb, driven with xdotool.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "unit/image/places.h"

namespace isomotion::player {

struct Pixels {
    int width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 3>> rgb; // the top row first

    const std::array<std::uint8_t, 3>& at(int x, int y) const {
        return rgb[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

class Display {
public:
    static constexpr int width = 1000, height = 700;

    // None where Xvfb or xdotool is not installed.
    static std::optional<std::string> missing();
    Display();
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    std::string name() const; // ":7"
    Pixels screenshot() const;
    // xdotool with these words; false if it fails.
    bool drive(std::vector<std::string> words) const;
    void end(); // as when the machine is shut down

private:
    image::TemporaryFolder folder_; // Xvfb keeps its screen in a file there
    pid_t server_ = -1;
    int number_ = -1;
};

} // namespace isomotion::player
