#include "display.h"

#include <fstream>
#include <span>
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
// of pixels, here blue, green, red and a byte of nothing. It is read often, by code that is not
// optimized.
std::vector<std::array<std::uint8_t, 3>> Display::screenshot(int left, int top, int width,
                                                             int height) const {
    std::ifstream file(folder_ / "Xvfb_screen0", std::ios::binary);
    enum { header_size, bits_a_pixel = 11, bytes_a_row, colors = 19, numbers = 25 };
    std::array<std::uint8_t, 4 * numbers> header{};
    const auto read = [&](std::size_t at, std::span<std::uint8_t> to) {
        file.seekg(std::streamoff(at));
        file.read(reinterpret_cast<char*>(to.data()), std::streamsize(to.size()));
        if (!file) throw std::runtime_error("the screen's file ends early");
    };
    read(0, header);
    const auto number = [&](std::size_t index) {
        const std::uint8_t* byte = header.data() + 4 * index;
        return std::size_t(byte[0]) << 24 | std::size_t(byte[1]) << 16 | std::size_t(byte[2]) << 8 |
               std::size_t(byte[3]);
    };
    if (number(bits_a_pixel) != 32) throw std::runtime_error("not a screen of 32 bits a pixel");
    constexpr std::size_t color_size = 12;
    const std::size_t begin = number(header_size) + color_size * number(colors);
    std::vector<std::uint8_t> row(4 * std::size_t(width));
    std::vector<std::array<std::uint8_t, 3>> pixels(std::size_t(width) * std::size_t(height));
    std::array<std::uint8_t, 3>* to = pixels.data();
    for (int y = top; y < top + height; ++y) {
        read(begin + std::size_t(y) * number(bytes_a_row) + 4 * std::size_t(left), row);
        const std::uint8_t* from = row.data();
        for (int x = 0; x < width; ++x, from += 4) *to++ = {from[2], from[1], from[0]};
    }
    return pixels;
}

} // namespace isomotion::player
