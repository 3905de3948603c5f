#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "animation/frame_range.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/progress.h"
#include "app/render_arguments.h"
#include "app/stop_on_signal.h"
#include "base/file.h"
#include "farm/chunks.h"
#include "farm/job.h"
#include "farm/local.h"
#include "farm/shell.h"
#include "farm/slurm.h"
#include "sequence/inputs.h"

namespace isomotion::app {
namespace fs = std::filesystem;
namespace {

using Words = std::vector<std::string>;

struct SubmitArguments {
    RenderArguments render;
    std::vector<CLI::Option*> picture; // options of render that go to the workers as they are
    std::string engine = "local";
    std::size_t chunk = farm::Cut{}.size, workers = 0;
    int tries = farm::Workforce{}.tries;
    Words sbatch;
    bool dry_run = false;
};

// The options as they were given: --name=value.
Words words_of(const std::vector<CLI::Option*>& options) {
    Words words;
    for (const CLI::Option* option : options) {
        const std::string name = "--" + option->get_lnames().front();
        if (option->count() > 0 && option->get_items_expected_max() == 0) {
            words.push_back(name);
        } else {
            for (const std::string& value : option->results())
                words.push_back(fmt::format("{}={}", name, value));
        }
    }
    return words;
}

std::size_t cores() { return std::max(1u, std::thread::hardware_concurrency()); }

class Submission {
public:
    explicit Submission(const SubmitArguments& arguments)
        : arguments_(arguments) {
        const RenderArguments& render = arguments.render;
        if (render.max_wrong) {
            throw std::invalid_argument(
                "--max-wrong: each chunk would choose for itself; let isomotion accuracy choose, "
                "and give --method and --step");
        }
        const Scene scene = scene_of(render);
        const Exporter exporter = exporter_of(scene, export_settings(render, scene));
        frames_ = exporter.frames();
        job_.program = fs::read_symlink("/proc/self/exe");
        job_.folder = fs::current_path();
        const auto file = scene.file();
        job_.scene = file ? fs::absolute(*file).string() : render.scene;
        job_.output = fs::absolute(exporter.output());
        job_.frames = all_frames(); // as short as they were written
        for (const std::string& movie : render.movies) job_.movies.push_back(fs::absolute(movie));
        job_.options = words_of(arguments.picture);
        if (arguments.engine == "slurm")
            sequence::Inputs(scene.files()).expect_apart("-o", script());
        if (const char* data = std::getenv("ISOMOTION_DATA")) {
            job_.environment.push_back("ISOMOTION_DATA=" + fs::absolute(data).string());
        }
        if (const char* largest = std::getenv("ISOMOTION_LARGEST_SHADERS")) {
            job_.environment.push_back(std::string("ISOMOTION_LARGEST_SHADERS=") + largest);
        }
    }

    int run() {
        if (arguments_.engine == "print") return print();
        if (arguments_.engine == "slurm") return slurm();
        return local();
    }

private:
    template<class... Args> void say(fmt::format_string<Args...> format, Args&&... args) const {
        if (!arguments_.render.quiet) print_result(format, std::forward<Args>(args)...);
    }

    // The frames as they were asked for: a movie shows them in that order.
    std::string all_frames() const {
        return arguments_.render.frames.empty() ? animation::frame_range(frames_)
                                                : arguments_.render.frames;
    }

    int print() const {
        const farm::Cut cut{.size = arguments_.chunk, .workers = arguments_.workers};
        for (const farm::Chunk& chunk : farm::chunks(frames_, cut)) {
            print_line(farm::chunk_words(job_, animation::frame_range(chunk)));
        }
        print_line(farm::joining_words(job_, all_frames()));
        return exit_done;
    }
    void print_line(const Words& words) const {
        print_result("{}\n", farm::shell_line(job_, words));
    }

    int local() {
        const std::size_t workers = arguments_.workers > 0 ? arguments_.workers : cores();
        const auto chunks = farm::chunks(frames_, {.size = arguments_.chunk, .workers = workers});
        job_.environment.push_back(fmt::format("{}=1", ends_with_input));
        // Any number of threads draws the same; one each is what several processes do best with.
        if (!std::getenv("LP_NUM_THREADS")) job_.environment.emplace_back("LP_NUM_THREADS=1");

        const auto begin = std::chrono::steady_clock::now();
        const StopOnSignal stop;
        stop.work_has_begun();
        farm::Ending ending;
        {
            Progress progress("rendering", int(frames_.size()), arguments_.render.quiet);
            const farm::Watcher watcher{
                .stop = [&] { return stop.asked(); },
                .progress = [&](int done) { progress.show(done); },
                .tell = [&](const std::string& text) { progress.tell(text); }};
            ending = farm::render_locally(job_, chunks, {workers, arguments_.tries}, watcher);
            // Frames are drawn again here where the scene's files changed behind them.
            if (ending.code == exit_done && !ending.stopped) {
                progress.show(int(frames_.size()),
                              job_.movies.empty() ? "looking at all frames" : "joining the movie");
                ending = join(ending, watcher);
            }
        }
        if (ending.stopped) {
            message("stopped; the frames written are whole, the same again (or render "
                    "--resume) renders the rest\n");
            return exit_interrupted;
        }
        if (ending.failed > 0) {
            message("{} of {} chunks failed; the same again (or render --resume) "
                    "renders the rest\n",
                    ending.failed, chunks.size());
        }
        if (ending.code != exit_done) return ending.code;
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
        say("{} frame{} in {} chunk{} by {} process{} in {:.2f} s", frames_.size(),
            frames_.size() == 1 ? "" : "s", chunks.size(), chunks.size() == 1 ? "" : "s",
            std::min(workers, chunks.size()), std::min(workers, chunks.size()) == 1 ? "" : "es",
            wall.count());
        if (ending.tried_again > 0) say("; {} tried again", ending.tried_again);
        say("\nframes: {}\n", output_text());
        for (const std::string& movie : arguments_.render.movies) say("movie: {}\n", movie);
        return exit_done;
    }

    farm::Ending join(const farm::Ending& rendered, const farm::Watcher& watcher) const {
        farm::Ending ending = farm::run_locally(farm::joining_words(job_, all_frames()), watcher);
        ending.tried_again = rendered.tried_again;
        return ending;
    }

    int slurm() const {
        farm::Slurm slurm{.script = script(),
                          .workers = arguments_.workers,
                          .tries = arguments_.tries,
                          .options = arguments_.sbatch};
        farm::Cut cut{.size = arguments_.chunk, .workers = arguments_.workers};
        cut.most = farm::largest_array();
        const auto chunks = farm::chunks(frames_, cut);
        if (const std::size_t size = chunks.back().size(); size > arguments_.chunk) {
            message("warning: this Slurm takes arrays of {} tasks: chunks have {} frames, not {}\n",
                    cut.most, size, arguments_.chunk);
        }
        const std::string text = farm::slurm_script(job_, chunks, all_frames(), slurm);
        fs::create_directories(slurm.script.parent_path());
        base::write_whole(slurm.script, std::as_bytes(std::span(text)));
        say("script: {}\n", slurm.script.string());
        const Words array = farm::sbatch_array(slurm, chunks.size());
        if (arguments_.dry_run) {
            say("{}\n{}\n", farm::command_line(array),
                farm::command_line(farm::sbatch_joining(slurm, "JOB")));
            return exit_done;
        }
        const std::string job = farm::submit(array);
        say("job {}: {} frames in {} chunks\n", job, frames_.size(), chunks.size());
        const std::string last = farm::submit(farm::sbatch_joining(slurm, job));
        say("job {}: after it, {}\n", last,
            job_.movies.empty()
                ? "sees that all frames are there"
                : fmt::format("joins {}", fmt::join(arguments_.render.movies, ", ")));
        return exit_done;
    }

    fs::path script() const {
        return job_.output.parent_path() / (farm::stem(job_.output) + ".slurm.sh");
    }

    std::string output_text() const {
        return arguments_.render.output.empty() ? job_.output.string() : arguments_.render.output;
    }

    const SubmitArguments& arguments_;
    std::vector<int> frames_;
    farm::Job job_;
};

} // namespace

void add_submit(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<SubmitArguments>();
    SubmitArguments& a = *arguments;
    CLI::App* command =
        app.add_subcommand("submit", "render a sequence by many processes, here or on a farm");
    add_sequence_options(*command, a.render);
    a.picture = add_picture_options(*command, a.render);
    command
        ->add_option("--engine", a.engine,
                     "local: processes of this machine; slurm: an array of jobs; print: commands "
                     "for any other farm")
        ->check(CLI::IsMember({"local", "slurm", "print"}));
    command->add_option("--chunk", a.chunk, "most frames of a chunk (20)")
        ->check(CLI::Range(1, 10'000'000));
    command
        ->add_option(
            "--workers", a.workers,
            "chunks rendered at a time (default: local as many as cores, slurm as it allows)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--tries", a.tries, "how often a chunk that fails is tried (3)")
        ->check(CLI::Range(1, 1000));
    command
        ->add_option(
            "--sbatch", a.sbatch,
            "slurm: pass an option to sbatch: --sbatch=--partition=gpu; may be given several times")
        ->allow_extra_args(false);
    command->add_flag("--dry-run", a.dry_run, "slurm: write the script and submit nothing");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return Submission(*arguments).run(); }; });
}

} // namespace isomotion::app
