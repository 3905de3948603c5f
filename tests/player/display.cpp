#include "display.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "base/child_process.h"
#include "cli/program.h"

namespace isomotion::player {

std::optional<std::string> Display::missing() {
    for (const char* program : {"Xvfb", "xdotool"}) {
        if (!base::find_program(program)) return program;
    }
    return std::nullopt;
}

bool Display::drive(std::vector<std::string> words) const {
    words.insert(words.begin(), base::find_program("xdotool").value().string());
    return cli::run(words, {.environment = {{"DISPLAY", name()}}}).code == 0;
}

// An X window dump (XWDFile.h): 25 numbers of 32 bits, high byte first; a name; a colour map; rows
// of pixels, here blue, green, red and a byte of nothing.
Pixels Display::screenshot() const {
    std::ifstream file(folder_ / "Xvfb_screen0", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const auto byte = [&](std::size_t at) { return std::uint8_t(bytes.at(at)); };
    const auto number = [&](std::size_t index) {
        const std::size_t at = 4 * index;
        return std::size_t(byte(at)) << 24 | std::size_t(byte(at + 1)) << 16 |
               std::size_t(byte(at + 2)) << 8 | std::size_t(byte(at + 3));
    };
    enum { header_size, width_at = 4, height_at, bits_a_pixel = 11, bytes_a_row, colors = 19 };
    constexpr std::size_t color_size = 12;
    if (number(bits_a_pixel) != 32) throw std::runtime_error("not a screen of 32 bits a pixel");
    Pixels pixels{int(number(width_at)), int(number(height_at)), {}};
    const std::size_t begin = number(header_size) + color_size * number(colors);
    for (int y = 0; y < pixels.height; ++y) {
        for (int x = 0; x < pixels.width; ++x) {
            const std::size_t at =
                begin + std::size_t(y) * number(bytes_a_row) + 4 * std::size_t(x);
            pixels.rgb.push_back({byte(at + 2), byte(at + 1), byte(at)});
        }
    }
    return pixels;
}

} // namespace isomotion::player
