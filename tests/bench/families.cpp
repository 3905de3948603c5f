// What timelines of families of motions cost that are drawn at random, as tests draw them
// (tests/topology/families.h), and what they leave open.
//
//     families_bench [--seeds 1-3,7] [--elements 20-150] [--limit SECONDS] [--threads N]
//                    [-o FOLDER] [--against FOLDER]
//
// A row of Markdown for each family. Times are the processor's, of all threads together. With -o
// the scenes and their timelines are kept; --against compares timelines with those kept, times to
// 1e-12 s.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "scene/reading/load.h"
#include "topology/analyse.h"
#include "topology/families.h"
#include "topology/timeline/compare.h"
#include "topology/timeline/timeline_file.h"
#include "words.h"

namespace isomotion::topology {
namespace {

struct Span {
    int first = 0, last = 0;
};

Span parse_span(const std::string& text) {
    Span span;
    char end = 0;
    const int read = std::sscanf(text.c_str(), "%d-%d%c", &span.first, &span.last, &end);
    if (read == 1) span.last = span.first;
    if ((read != 1 && read != 2) || span.first < 1 || span.last < span.first) {
        throw std::invalid_argument(text + ": write 7 or 1-40, from 1 on");
    }
    return span;
}

std::vector<int> all_of(const std::vector<Span>& spans) {
    std::vector<int> all;
    for (const Span& span : spans) {
        for (int k = span.first; k <= span.last; ++k) all.push_back(k);
    }
    return all;
}

struct Arguments {
    std::vector<Span> seeds{{1, 40}};
    Span elements{20, 150};
    double limit = 120;
    int threads = 1;
    std::filesystem::path folder = "", against = "";
};

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Measured {
    TimelineRecord record;
    std::map<std::string, double> seconds; // by phase
    double all = 0;
    std::string cut_off_in; // a phase, if it took too long
};

Measured measure(const scene::Scene& scene, double limit, int threads) {
    Measured measured;
    const double start = processor_seconds();
    double last = start;
    std::string phase = "events";
    const auto add = [&] {
        const double now = processor_seconds();
        measured.seconds[phase] += now - last;
        last = now;
    };
    AnalyseOptions how;
    how.threads = threads;
    how.progress = [&](const std::string& what, double) {
        add();
        phase = what;
    };
    how.stop = [&] {
        const bool is_late = processor_seconds() - start > limit;
        if (is_late && measured.cut_off_in.empty()) measured.cut_off_in = phase;
        return is_late;
    };
    Timeline timeline = analyse(scene, how);
    add();
    measured.all = last - start;
    measured.record = {header_of(scene, timeline.range), std::move(timeline)};
    return measured;
}

std::string state_of(const Measured& measured) {
    if (!measured.cut_off_in.empty()) return "cut off in " + measured.cut_off_in;
    return measured.record.timeline.is_complete() ? "complete" : "INCOMPLETE";
}

// What makes a timeline incomplete, a line each.
void print_open(const Timeline& timeline) {
    for (const Event& event : timeline.events) {
        if (event.kind != Kind::unknown && event.is_proved && event.is_proved_again) continue;
        fmt::print("    open: {} at {:.12g} s, index {}, {}, stratum {}, ({:.6f}, {:.6f}, "
                   "{:.6f}), proved {} {}\n",
                   name(event.kind), mid(event.time), event.index,
                   event.grows ? "grows" : "shrinks", event.stratum, mid(event.where[0]),
                   mid(event.where[1]), mid(event.where[2]), event.is_proved,
                   event.is_proved_again);
    }
    for (const Unresolved& place : timeline.unresolved) {
        fmt::print("    unresolved: {:.12g} s, ({:.6f}, {:.6f}, {:.6f}): {}\n", mid(place.time),
                   mid(place.where[0]), mid(place.where[1]), mid(place.where[2]), place.why);
    }
    for (const std::string& doubt : timeline.doubts) fmt::print("    doubt: {}\n", doubt);
}

// Whether both tell the same.
bool print_differences(const TimelineRecord& found, const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return true;
    const Check check = compare(read_timeline(file), found, 1e-12);
    for (const auto* lines : {&check.differences, &check.undecided}) {
        for (const std::string& line : *lines) fmt::print("    {}\n", line);
    }
    return check.differences.empty();
}

int run(const Arguments& arguments) {
    const auto scratch = std::filesystem::temp_directory_path() /
                         fmt::format("families-bench-{}.toml", std::clock());
    fmt::print("| seed | elements | events | unknown kinds | events s | ends s | kinds s | again s "
               "| all s | |\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|\n");
    std::vector<double> all;
    bool is_same = true;
    for (const int seed : all_of(arguments.seeds)) {
        const FamilyDraw drawn =
            draw_family(unsigned(seed), arguments.elements.first, arguments.elements.last);
        const std::string stem = fmt::format("family_{}", seed);
        const auto kept = [&](const std::filesystem::path& folder) {
            return folder / (stem + ".timeline.json");
        };
        const auto file = arguments.folder.empty() ? scratch : arguments.folder / (stem + ".toml");
        std::ofstream(file) << drawn.text;
        const scene::Scene scene = scene::load(file.string());
        if (arguments.folder.empty()) std::filesystem::remove(file);
        int elements = 0;
        for (const int count : scene.surfaces[0].animation.counts()) elements += count;
        Measured measured = measure(scene, arguments.limit, arguments.threads);
        const Timeline& timeline = measured.record.timeline;
        const auto unknown = std::ranges::count(timeline.events, Kind::unknown, &Event::kind);
        fmt::print("| {} | {} | {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {}: {} |\n",
                   seed, elements, timeline.events.size(), unknown, measured.seconds["events"],
                   measured.seconds["first and last frame"], measured.seconds["kinds"],
                   measured.seconds["proofs again"], measured.all, state_of(measured),
                   drawn.name.substr(drawn.name.find(": ") + 2));
        if (!timeline.is_complete()) print_open(timeline);
        if (!arguments.folder.empty())
            std::ofstream(kept(arguments.folder)) << to_json(measured.record);
        if (!arguments.against.empty())
            is_same = print_differences(measured.record, kept(arguments.against)) && is_same;
        std::fflush(stdout);
        all.push_back(measured.all);
    }
    std::ranges::sort(all);
    fmt::print("median {:.1f} s, most {:.1f} s\n", all[all.size() / 2], all.back());
    return is_same ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace isomotion::topology

int main(int argc, char** argv) {
    using namespace isomotion::topology;
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    Arguments arguments;
    std::vector<std::string> seeds;
    std::string elements;
    isomotion::bench::Words words("What timelines of random families of motions cost");
    words.texts("--seeds", seeds, "families to draw");
    words.text("--elements", elements, "elements of each, from the fewest to the most");
    words.number("--limit", arguments.limit, "seconds of the processor's time for each");
    words.number("--threads", arguments.threads, "of each family");
    words.folder("-o", arguments.folder, "where scenes and timelines are kept");
    words.folder("--against", arguments.against, "timelines to compare with");
    if (const auto code = words.read(argc, argv)) return *code;
    try {
        if (!seeds.empty()) arguments.seeds.clear();
        for (const std::string& text : seeds) arguments.seeds.push_back(parse_span(text));
        if (!elements.empty()) arguments.elements = parse_span(elements);
    } catch (const std::invalid_argument& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return run(arguments);
}
