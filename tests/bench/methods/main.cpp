// Compares the methods that find roots: time, wrong pixels, and time at equal accuracy.
//
//   methods -o FOLDER [--only SURFACE,...] [--methods a,b] [--size N] [--repeat N] [--frames R] ...
//
// writes methods.csv, coherence.csv, growth.csv, methods.md and plots to FOLDER. --only '' leaves
// the surfaces out, --frames '' the animation, --moving '' the coherence, --sizes '', --blobs '',
// --degrees '' and --lights '' the growth.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

#include "accuracy/truth_cache.h"
#include "animation/frame_range.h"
#include "machine.h"
#include "methods/peak.h"
#include "methods/plots.h"
#include "methods/tables.h"
#include "words.h"

namespace isomotion::bench {
namespace {

struct Arguments {
    std::string folder, backend = "auto", frames = "1-120x12", methods, only = "all";
    std::string sizes = "128,256,512,1024,2048", growing = "barth_sextic,blinn_blobby";
    std::string blobs = "75,150,300,1000,5000", degrees = "6,8,12,14,18,22,50", lights = "1,2,4,8";
    std::string moving = "blobby75,twisting_superquadric,barth_sextic,chmutov_14";
    std::string moving_frames = "25-97x24";
    int size = 512, repeat = 5, blob_size = 128, growing_size = 256, most_halvings = 6;
};

std::vector<std::string> listed(const std::string& text) {
    std::vector<std::string> items;
    std::istringstream stream(text);
    for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
    return items;
}

std::vector<int> numbers(const std::string& text) {
    std::vector<int> values;
    for (const std::string& item : listed(text)) {
        values.push_back(std::stoi(item));
        if (values.back() < 1) throw std::invalid_argument(text + ": write numbers above 0");
    }
    return values;
}

std::vector<scene::Method> parse_methods(const std::string& text) {
    std::vector<scene::Method> methods;
    if (text.empty()) {
        for (const auto& entry : scene::method_traits) methods.push_back(entry.method);
    }
    for (const std::string& item : listed(text)) {
        const auto method = scene::parse_method(item);
        if (!method) throw std::invalid_argument("--methods: there is no method " + item);
        methods.push_back(*method);
    }
    return methods;
}

void tell(const std::string& what) { fmt::print(stderr, "{}\n", what); }

// Percents on a terminal only: in a file a line a subject is enough.
Progress certifying(const std::string& name) {
    tell(name);
    if (!isatty(2)) return {};
    return [](double part) {
        fmt::print(stderr, "\r  truth {:3.0f}%{}", 100 * part, part < 1 ? "" : "\r            \r");
    };
}

void write(const Results& results, const std::filesystem::path& folder) {
    std::ofstream(folder / "methods.csv") << contests_csv(results);
    std::ofstream(folder / "coherence.csv") << coherence_csv(results);
    std::ofstream(folder / "growth.csv") << growth_csv(results);
    std::ofstream(folder / "methods.md") << markdown(results);
}

void run(const Arguments& arguments) {
    const std::vector<scene::Method> methods = parse_methods(arguments.methods);
    const std::vector<std::string> surfaces =
        arguments.only == "all" ? table_1() : listed(arguments.only);
    const std::vector<int> sizes = numbers(arguments.sizes), counts = numbers(arguments.blobs);
    const std::vector<int> degrees = numbers(arguments.degrees), lights = numbers(arguments.lights);
    const auto cache = accuracy::truth_cache_folder();
    const auto context = gpu::Context::create(gpu::parse_backend(arguments.backend));
    std::filesystem::create_directories(arguments.folder);

    Results results{machine(context->info()),
                    today(),
                    0,
                    arguments.repeat,
                    arguments.most_halvings,
                    {},
                    {},
                    {},
                    {}};
    tell("peak");
    results.peak = peak_operations(*context);
    const auto held = [&](Subject subject) {
        const std::string name = subject.name;
        const Certified on = certified(std::move(subject), arguments.size, cache, certifying(name));
        return hold(*context, on, methods, arguments.most_halvings, arguments.repeat);
    };
    for (const std::string& name : surfaces) {
        results.surfaces.push_back(held(surface(name)));
        write(results, arguments.folder); // a run that is ended leaves what it had
    }
    if (!arguments.frames.empty()) {
        results.animations.push_back(
            held(animation("blobby75", animation::parse_frame_range(arguments.frames))));
        write(results, arguments.folder);
    }
    for (const std::string& name : listed(arguments.moving)) {
        const auto frames = animation::parse_frame_range(arguments.moving_frames);
        const Certified on =
            certified(animation(name, frames), arguments.size, cache, certifying(name));
        results.coherence.push_back(coherence(*context, on, arguments.repeat));
        write(results, arguments.folder);
    }
    results.growth =
        by_resolution(*context, listed(arguments.growing), sizes, methods, arguments.repeat, tell);
    write(results, arguments.folder);
    const auto add = [&](const std::vector<Growth>& more) {
        results.growth.insert(results.growth.end(), more.begin(), more.end());
        write(results, arguments.folder);
    };
    add(by_blobs(*context, arguments.blob_size, counts, methods, arguments.repeat, tell));
    add(by_degree(*context, arguments.growing_size, degrees, methods, arguments.repeat, tell));
    add(by_lights(*context, arguments.growing_size, lights, methods, arguments.repeat, tell));
    // Again, as whatever else the machine does at a time only takes from it.
    results.peak = std::max(results.peak, peak_operations(*context));
    write(results, arguments.folder);
    plot(results, arguments.folder);
    fmt::print("{}/methods.md\n", arguments.folder);
}

} // namespace
} // namespace isomotion::bench

int main(int argc, char** argv) {
    isomotion::bench::Arguments arguments;
    isomotion::bench::Words words("compares the methods that find roots");
    words.text("-o,--output", arguments.folder, "folder for tables and plots");
    words.require("--output");
    words.text("--only", arguments.only, "surfaces a,b (default: all of Table I; '' for none)");
    words.text("--methods", arguments.methods, "a,b (default: all)");
    words.number("--size", arguments.size, "pixels a side", {8, 4096});
    words.number("--repeat", arguments.repeat, "frames a median is taken of", {1, 1000});
    words.text("--frames", arguments.frames, "of blobby75 ('' for none)");
    words.number("--halvings", arguments.most_halvings, "of the sign test's step, at most",
                 {0, 12});
    words.text("--moving", arguments.moving, "animations of which the coherence is measured");
    words.text("--moving-frames", arguments.moving_frames, "of these");
    words.text("--sizes", arguments.sizes, "of the growth with resolution ('' for none)");
    words.text("--growing", arguments.growing, "surfaces of which that is measured");
    words.text("--blobs", arguments.blobs, "numbers of blobs ('' for none)");
    words.number("--blob-size", arguments.blob_size, "pixels a side of their pictures");
    words.text("--degrees", arguments.degrees, "of Chmutov's surfaces ('' for none)");
    words.text("--lights", arguments.lights, "numbers of lights with shadows ('' for none)");
    words.number("--growing-size", arguments.growing_size, "pixels a side of both");
    words.text("--backend", arguments.backend, "auto, egl or osmesa");
    if (const auto code = words.read(argc, argv)) return *code;
    try {
        isomotion::bench::run(arguments);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
