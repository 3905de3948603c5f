// What a graphics card reaches: methods in fragment and in compute shaders, by the card's own
// clock.
//
//   stages_bench [-o FILE.csv] [--only SURFACE,...] [--blobs N,...] [--methods a,b] [--stages a,b]
//                [--size N] [--count-size N] [--rounds N] [--finer N] [--halvings N] [--one-draw]
//                [--beams on|off]
//
// Prints a line for each subject, stage and method. Wrong pixels are counted at --count-size; times
// are of --size, medians, and of the card, which other work keeps at the clock that it has under
// load: reading back, which takes longer there than marching, is not in them. The sign test
// (amp-sign) has further lines with its step halved until it gets no more pixels wrong than the
// best other method, or --halvings are spent. Operations are those of the field alone, as in
// `methods`, and the peak is that of the stage.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "accuracy/truth_cache.h"
#include "machine.h"
#include "methods/contest.h"
#include "methods/peak.h"
#include "shader/assemble.h"
#include "words.h"

namespace isomotion::bench {
namespace {

using shader::Channel, shader::Stage;

struct Arguments {
    std::string output, backend = "auto", only = "all", blobs, animations = "blobby75";
    std::string methods = "amp-sign,hermite", stages = "fragment,compute";
    int size = 1024, count_size = 512, rounds = 9, finer = 0, halvings = 6;
    bool one_draw = false;
    std::string beams; // on, off; otherwise as the scene has them
};

std::vector<std::string> listed(const std::string& text) {
    std::vector<std::string> items;
    std::istringstream stream(text);
    for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
    return items;
}

struct Line {
    std::string subject;
    Stage stage;
    scene::Method method;
    bool has_beams = false;
    int halvings = 0;
    double compiling = 0;             // s, up to the first picture
    double marching = 0, drawing = 0; // ms
    int passes = 0;
    double rays = 0, evaluations = 0; // of a picture of the size
    std::int64_t wrong = -1;          // of a picture of the counted size; -1: not counted
    double operations = 0;            // of an evaluation
};

// One surface by one method in one stage, compiled once for pictures of both sizes.
class Drawer {
public:
    Drawer(gpu::Context& context, const Certified& on, const Arguments& arguments,
           scene::Method method, Stage stage)
        : on_(on)
        , scene_(on.subject.scene)
        , arguments_(arguments)
        , line_{on.subject.name, stage, method} {
        scene_.surfaces[0].isolation.method = method;
        if (!arguments.beams.empty()) scene_.surfaces[0].isolation.beam = arguments.beams == "on";
        render::RenderOptions options{
            arguments.size, arguments.size, {Channel::normal, Channel::position, Channel::verdict}};
        options.stage =
            stage == Stage::compute ? render::StageChoice::compute : render::StageChoice::fragment;
        options.times_rays = true;
        if (arguments.one_draw)
            options.plan = render::MarchPlan{arguments.size, arguments.size, 60'000};
        const auto begin = std::chrono::steady_clock::now();
        timed_ = std::make_unique<render::Renderer>(context, scene_, options);
        timed_->draw(on.frames[0]); // drivers make their code and memory at the first draw
        line_.compiling =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        if (!on.truths.empty()) {
            options.width = options.height = arguments.count_size;
            options.channels = {Channel::normal, Channel::position, Channel::verdict};
            counted_ = std::make_unique<render::Renderer>(context, scene_, options);
        }
        line_.has_beams =
            !shader::assemble(scene_, {},
                              {.stage = stage,
                               .writes_buffers = context.info().has(4, 3),
                               .pixels = std::int64_t(arguments.size) * arguments.size})
                 .beams.empty();
        line_.operations = operations(on.subject.scene, method);
        if (!context.info().software) load_.emplace(stage);
    }

    void halve(int halvings) {
        line_.halvings = halvings;
        scene_.surfaces[0].isolation.step =
            std::ldexp(on_.subject.scene.surfaces[0].isolation.step, -halvings);
        timed_->adjust(scene_.surfaces[0].isolation);
        if (counted_) counted_->adjust(scene_.surfaces[0].isolation);
    }

    std::int64_t wrong() {
        if (!counted_) return -1;
        const render::Picture picture = counted_->draw(on_.frames[0]);
        return accuracy::compare(on_.frames[0], picture.frame, on_.truths[0]).wrong();
    }

    // Times it as it is set, and counts what is wrong.
    Line measured() {
        Line line = line_;
        line.wrong = wrong();
        std::vector<double> marching, drawing;
        for (int round = 0; round < arguments_.rounds; ++round) {
            draw([&](const render::Picture& picture) {
                drawing.push_back(1e3 * picture.drawing.count());
            });
            if (load_) load_->begin();
            draw([&](const render::Picture& picture) {
                line.passes = picture.passes;
                line.evaluations = double(picture.evaluations());
                marching.push_back(1e3 * picture.marching.count());
            });
        }
        line.marching = median(std::move(marching));
        line.drawing = median(std::move(drawing));
        return line;
    }

private:
    template<class Take> void draw(const Take& take) {
        render::Picture picture = timed_->draw(on_.frames[0]);
        take(picture);
        timed_->reuse(std::move(picture));
    }

    static double median(std::vector<double> values) {
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    }

    const Certified& on_;
    scene::Scene scene_;
    const Arguments& arguments_;
    Line line_;
    std::unique_ptr<render::Renderer> timed_, counted_;
    std::optional<Load> load_;
};

class Table {
public:
    Table(const std::string& file, std::map<Stage, double> peaks)
        : csv_(file.empty() ? std::ofstream() : std::ofstream(file))
        , peaks_(std::move(peaks)) {
        csv_ << "subject,stage,method,beams,step_over,compiling_s,march_ms,frame_ms,passes,rays,"
                "evaluations,wrong,operations_of_evaluation,part_of_peak\n";
        fmt::print(
            "| subject | stage | method | step | compiled in s | march ms | frame ms | passes "
            "| Mray/s | evaluations a ray | wrong | Gop/s | of the peak |\n"
            "|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    }

    void add(const Line& line) {
        const double rate = line.operations * line.evaluations / (1e-3 * line.marching);
        const double part = rate / peaks_.at(line.stage);
        const std::string wrong = line.wrong < 0 ? "" : fmt::format("{}", line.wrong);
        fmt::print("| {} | {} | {} | {}{} | {:.1f} | {:.3f} | {:.2f} | {} | {:.0f} | {:.1f} | {} | "
                   "{:.0f} | {:.1f}% |\n",
                   line.subject, render::name(line.stage), scene::name(line.method),
                   line.halvings ? "1/" : "", 1 << line.halvings, line.compiling, line.marching,
                   line.drawing, line.passes, line.rays / line.marching / 1e3,
                   line.evaluations / line.rays, wrong, 1e-9 * rate, 100 * part);
        std::fflush(stdout);
        csv_ << fmt::format("{},{},{},{},{},{:.3f},{:.4f},{:.4f},{},{},{},{},{},{:.5f}\n",
                            line.subject, render::name(line.stage), scene::name(line.method),
                            line.has_beams ? "yes" : "no", 1 << line.halvings, line.compiling,
                            line.marching, line.drawing, line.passes, line.rays, line.evaluations,
                            wrong, line.operations, part)
             << std::flush;
    }

private:
    std::ofstream csv_;
    std::map<Stage, double> peaks_;
};

void measure(gpu::Context& context, const Certified& on, const Arguments& arguments,
             const std::vector<Stage>& stages, const std::vector<scene::Method>& methods,
             Table& table) {
    const double part = double(arguments.size) / arguments.count_size;
    const double all_rays = double(rays(on)) * part * part;
    for (const Stage stage : stages) {
        std::optional<Drawer> sign_test;
        std::int64_t fewest_wrong = -1; // of the other methods
        for (const scene::Method method : methods) {
            try {
                Drawer drawer(context, on, arguments, method, stage);
                if (method == scene::Method::amp_sign) drawer.halve(arguments.finer);
                Line line = drawer.measured();
                line.rays = all_rays;
                table.add(line);
                if (method == scene::Method::amp_sign) {
                    sign_test.emplace(std::move(drawer));
                } else if (line.wrong >= 0) {
                    fewest_wrong =
                        fewest_wrong < 0 ? line.wrong : std::min(fewest_wrong, line.wrong);
                }
            } catch (const std::exception& error) {
                const std::string text = error.what();
                fmt::print("| {} | {} | {} | no: {} |\n", on.subject.name, render::name(stage),
                           scene::name(method), text.substr(0, text.find('\n')));
            }
        }
        if (!sign_test || fewest_wrong < 0) continue;
        int halvings = arguments.finer;
        while (halvings < arguments.halvings && sign_test->wrong() > fewest_wrong)
            sign_test->halve(++halvings);
        if (halvings == arguments.finer) continue;
        Line line = sign_test->measured();
        line.rays = all_rays;
        table.add(line);
    }
}

void run(const Arguments& arguments) {
    std::vector<scene::Method> methods;
    for (const std::string& item : listed(arguments.methods)) {
        const auto method = scene::parse_method(item);
        if (!method) throw std::invalid_argument("--methods: there is no method " + item);
        methods.push_back(*method);
    }
    const auto context = gpu::Context::create(gpu::parse_backend(arguments.backend));
    std::vector<Stage> stages;
    std::map<Stage, double> peaks;
    fmt::print("{}, {}. {} x {} pixels, wrong of {} x {}, medians of {}.\n",
               machine(context->info()), today(), arguments.size, arguments.size,
               arguments.count_size, arguments.count_size, arguments.rounds);
    for (const std::string& item : listed(arguments.stages)) {
        const Stage stage = render::choose_stage(render::parse_stage(item), context->info());
        stages.push_back(stage);
        peaks[stage] = peak_operations(*context, stage);
        fmt::print("Peak of multiply-adds in {} shaders: {:.0f} Gop/s.\n", render::name(stage),
                   1e-9 * peaks[stage]);
    }
    fmt::print("\n");
    Table table(arguments.output, peaks);
    const auto cache = accuracy::truth_cache_folder();
    const auto take = [&](const Certified& on) {
        measure(*context, on, arguments, stages, methods, table);
    };
    for (const std::string& name : arguments.only == "all" ? table_1() : listed(arguments.only))
        take(certified(surface(name), arguments.count_size, cache));
    for (const std::string& name : listed(arguments.animations))
        take(certified(animation(name, {49}), arguments.count_size, cache));
    for (const std::string& count : listed(arguments.blobs))
        take(uncertified(blobs(std::stoi(count)), arguments.count_size));
}

} // namespace
} // namespace isomotion::bench

int main(int argc, char** argv) {
    isomotion::bench::Arguments arguments;
    isomotion::bench::Words words(
        "times methods in fragment and compute shaders by the graphics card's clock");
    words.text("-o,--output", arguments.output, "CSV file");
    words.text("--only", arguments.only, "surfaces a,b (default: all of Table I; '' for none)");
    words.text("--animations", arguments.animations, "a,b ('' for none), frame 49");
    words.text("--blobs", arguments.blobs, "numbers of blobs");
    words.text("--methods", arguments.methods, "a,b");
    words.text("--stages", arguments.stages, "fragment,compute");
    words.number("--size", arguments.size, "pixels a side of timed pictures, a multiple of 64");
    words.number("--count-size", arguments.count_size, "of those with counted wrong pixels");
    words.number("--rounds", arguments.rounds, "pictures a median is taken of", {1, 1000});
    words.number("--finer", arguments.finer, "halvings of its step to begin with", {0, 12});
    words.number("--halvings", arguments.halvings, "of the sign test's step, at most", {0, 12});
    words.flag("--one-draw", arguments.one_draw, "one tile, as many evaluations as rays need");
    words.one_of({"on", "off"}, "--beams", arguments.beams,
                 "for all methods, or for none (default: by method and stage)");
    words.text("--backend", arguments.backend, "auto, egl or osmesa");
    if (const auto code = words.read(argc, argv)) return *code;
    try {
        isomotion::bench::run(arguments);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
