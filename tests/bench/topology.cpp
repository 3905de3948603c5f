// What the proved search for events costs: boxes, time, and which test removed how many of them.
// topology [--threads N] [SCENE:FROM:TO...], times in seconds
// topology [--threads N] --phases SCENE...: what a whole timeline costs, phase by phase
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scene/reading/load.h"
#include "topology/analyse.h"
#include "topology/field/motion.h"
#include "topology/search/comoving_fit.h"
#include "topology/search/search.h"

namespace isomotion::topology {
namespace {

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

void report(const std::string& name, double from, double to, int threads) {
    const scene::Scene scene = scene::load(name);
    SearchResult all;
    const double cpu = cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    for (const Motion& motion : motions(scene, Side::negative, {from, to}).pieces) {
        const MovingField field = comoving_field(motion, Stratum{});
        SearchOptions how;
        how.threads = threads;
        SearchResult found = search(field, how);
        all.points.insert(all.points.end(), found.points.begin(), found.points.end());
        all.unresolved.insert(all.unresolved.end(), found.unresolved.begin(),
                              found.unresolved.end());
        all.work += found.work;
    }
    const double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double seconds = cpu_seconds() - cpu;
    const Work& work = all.work;
    fmt::print("{} {} to {} s: {} points, {} unresolved, {} boxes, {:.2f} s CPU, {:.2f} s wall, "
               "{:.0f} ns a box\n",
               name, from, to, all.points.size(), all.unresolved.size(), work.boxes, seconds, wall,
               1e9 * seconds / double(work.boxes));
    for (std::size_t k = 0; k < work.removed.size(); ++k) {
        fmt::print("  {:<28}{:>10}  {:>5.1f} %\n", name_of(Test(k)), work.removed[k],
                   100 * double(work.removed[k]) / double(work.boxes));
    }
}

// Prints the processor time that all threads together take for each phase.
void report_phases(const std::string& name, int threads) {
    const scene::Scene scene = scene::load(name);
    std::vector<std::pair<std::string, double>> began; // what, and at which second
    AnalyseOptions how;
    how.threads = threads;
    how.progress = [&](const std::string& what, double) {
        if (began.empty() || began.back().first != what) began.emplace_back(what, cpu_seconds());
    };
    const double start = cpu_seconds();
    const Timeline timeline = analyse(scene, how);
    began.emplace_back("", cpu_seconds());
    fmt::print("{}: {} events, {}, {:.2f} s CPU:", name, timeline.events.size(),
               timeline.is_complete() ? "complete" : "INCOMPLETE", cpu_seconds() - start);
    for (std::size_t k = 0; k + 1 < began.size(); ++k)
        fmt::print(" {} {:.2f} s;", began[k].first, began[k + 1].second - began[k].second);
    fmt::print("\n");
}

} // namespace

int run(const std::vector<std::string>& arguments) {
    int threads = 1;
    bool by_phase = false;
    std::vector<std::string> scenes;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        if (arguments[k] == "--threads" && k + 1 < arguments.size()) {
            threads = std::stoi(arguments[++k]);
        } else if (arguments[k] == "--phases") {
            by_phase = true;
        } else {
            scenes.push_back(arguments[k]);
        }
    }
    if (scenes.empty()) scenes = {ISOMOTION_SOURCE_DIR "/animations/blobby75.toml:0:2"};
    for (const std::string& scene : scenes) {
        if (by_phase) {
            report_phases(scene, threads);
            continue;
        }
        const std::size_t last = scene.rfind(':');
        const std::size_t first = last == scene.npos ? last : scene.rfind(':', last - 1);
        if (first == scene.npos) {
            fmt::print(stderr, "{}: write SCENE.toml:FIRST:LAST, times in seconds\n", scene);
            return 2;
        }
        report(scene.substr(0, first), std::stod(scene.substr(first + 1, last - first - 1)),
               std::stod(scene.substr(last + 1)), threads);
    }
    return 0;
}

} // namespace isomotion::topology

int main(int argc, char** argv) {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    return isomotion::topology::run({argv + 1, argv + argc});
}
