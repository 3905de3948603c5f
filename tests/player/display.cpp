#include "display.h"

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

#include "cli/program.h"
#include "image/child_process.h"

namespace isomotion::player {

std::optional<std::string> Display::missing() {
    for (const char* program : {"Xvfb", "xdotool"}) {
        if (!image::find_program(program)) return program;
    }
    return std::nullopt;
}

Display::Display() {
    int told[2];
    if (::pipe(told) != 0) throw std::runtime_error("pipe");
    const std::string program = image::find_program("Xvfb").value().string();
    const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
    const std::string descriptor = std::to_string(told[1]), folder = folder_.path().string();
    server_ = ::fork();
    if (server_ == 0) {
        ::close(told[0]);
        ::freopen("/dev/null", "w", stderr);
        ::execl(program.c_str(), "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0",
                screen.c_str(), "-fbdir", folder.c_str(), "-nolisten", "tcp", nullptr);
        ::_exit(127);
    }
    ::close(told[1]);
    std::string text;
    for (char c; ::read(told[0], &c, 1) == 1 && c != '\n';) text.push_back(c);
    ::close(told[0]);
    if (text.empty()) throw std::runtime_error("Xvfb does not start");
    number_ = std::stoi(text);
}

Display::~Display() { end(); }

void Display::end() {
    if (server_ <= 0) return;
    ::kill(server_, SIGTERM);
    ::waitpid(server_, nullptr, 0);
    server_ = -1;
}

std::string Display::name() const { return ":" + std::to_string(number_); }

bool Display::drive(std::vector<std::string> words) const {
    words.insert(words.begin(), image::find_program("xdotool").value().string());
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
