// Simulates water and writes its particles, one PLY file a frame, for animations of water.
//
//   cmake --build build/release --target make_water
//   build/release/tools/make_water dam OUT_DIR [--frames 120] [--particles 50000]
//   build/release/tools/make_water splash OUT_DIR [--frames 8] [--first 8] [--particles 100000]
//
// Files are OUT_DIR/dam.0001.ply and so on; ply.h has their columns and anisotropy.h how a surface
// is made of them. The same bytes come out on each run, whatever the number of threads.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

#include "anisotropy.h"
#include "base/file.h"
#include "ply.h"
#include "situations.h"

namespace {

constexpr const char* usage =
    "usage: make_water dam|splash OUT_DIR [--frames N] [--first N] [--particles N] [--threads N]\n";

struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Request {
    std::string name;
    std::filesystem::path folder;
    int first = 1, frames = 120, particles = 50000;
    int threads = int(std::max(1U, std::thread::hardware_concurrency()));
};

int number(std::string_view option, std::string_view text, int least, int most) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
        throw UsageError(std::string(option) + ": not a whole number from " +
                         std::to_string(least) + " to " + std::to_string(most));
    return value;
}

Request request_of(int count, char** arguments) {
    if (count < 3 || count % 2 == 0) throw UsageError("a situation, a folder and options");
    Request request;
    request.name = arguments[1];
    request.folder = arguments[2];
    if (request.name == "splash") {
        request.first = request.frames = 8; // where the crown is highest and whole
        request.particles = 100000;
    } else if (request.name != "dam") {
        throw UsageError("no such situation");
    }
    for (int i = 3; i < count; i += 2) {
        const std::string_view option = arguments[i], text = arguments[i + 1];
        if (option == "--frames")
            request.frames = number(option, text, 1, 9999);
        else if (option == "--first")
            request.first = number(option, text, 1, 9999);
        else if (option == "--particles")
            request.particles = number(option, text, 100, 1000000);
        else if (option == "--threads")
            request.threads = number(option, text, 1, 256);
        else
            throw UsageError(std::string(option) + ": no such option");
    }
    return request;
}

void write_frame(const Request& request, int frame, const water::Fluid& fluid) {
    char number[16];
    std::snprintf(number, sizeof number, ".%04d.ply", frame);
    isomotion::base::write_whole(request.folder / (request.name + number),
                                 water::ply_of(water::blobs_of(fluid, {})));
}

void simulate(const Request& request) {
    std::filesystem::create_directories(request.folder);
    const auto threads = unsigned(request.threads);
    water::Fluid fluid = request.name == "dam" ? water::dam_break(request.particles, threads)
                                               : water::ball_into_pool(request.particles, threads);
    std::printf("%zu particles, %g apart\n", fluid.positions().size(),
                double(fluid.settings().spacing));
    for (int frame = 1; frame <= request.frames; ++frame) {
        const water::Fluid::Work before = fluid.work();
        if (frame > 1) fluid.advance(1.0F / 30);
        if (frame >= request.first) write_frame(request, frame, fluid);
        const water::Fluid::Work& work = fluid.work();
        std::printf("frame %d: %ld steps, %ld + %ld iterations\n", frame, work.steps - before.steps,
                    work.divergence_iterations - before.divergence_iterations,
                    work.density_iterations - before.density_iterations);
        std::fflush(stdout);
    }
}

} // namespace

int main(int count, char** arguments) {
    try {
        simulate(request_of(count, arguments));
    } catch (const UsageError& error) {
        std::fprintf(stderr, "make_water: %s\n%s", error.what(), usage);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
