#include <chrono>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "accuracy/measure.h"
#include "accuracy/truth_cache.h"
#include "app/commands.h"
#include "app/frame_metadata.h"
#include "app/frame_progress.h"
#include "app/frame_record.h"
#include "app/progress.h"
#include "app/render_arguments.h"
#include "app/render_totals.h"
#include "app/stop_on_signal.h"
#include "base/file.h"
#include "base/fingerprint.h"
#include "image/movie.h"
#include "image/sequence.h"
#include "render/exposure.h"
#include "render/renderer.h"
#include "scene/reading/load.h"
#include "sequence/manifest.h"
#include "sequence/recording.h"
#include "sequence/standing.h"

namespace isomotion::app {
namespace fs = std::filesystem;
namespace {

void make_folder(const fs::path& file) {
    const fs::path folder = file.parent_path();
    if (folder.empty()) return;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error && !fs::is_directory(folder)) {
        throw base::FileError(folder, "the folder cannot be created", error.value());
    }
}

class RenderJob {
public:
    explicit RenderJob(const RenderArguments& arguments)
        : arguments_(arguments)
        , scene_(scene::load(arguments.scene, overrides(arguments), arguments.reach))
        , backend_(gpu::parse_backend(arguments.backend))
        , stage_(render::parse_stage(arguments.stage))
        , channels_(parse_channels(arguments.channels))
        , frames_(frames_of(arguments, scene_))
        , output_(output_of(arguments, scene_))
        , name_(image::SequenceName::parse(output_))
        , format_(image::format_of(output_, arguments.bits == 16 ? image::PngDepth::bits16
                                                                 : image::PngDepth::bits8)) {
        name_.check_holds(frames_.size());
        if (format_ == image::Format::exr && arguments.bits != 8) {
            throw std::invalid_argument("--bits is of a PNG; an EXR holds half floats");
        }
        if (format_ != image::Format::exr && !channels_.empty()) {
            throw std::invalid_argument(
                fmt::format("--channels: a PNG holds the picture alone; write an EXR: -o {}",
                            fs::path(output_).replace_extension(".exr").string()));
        }
        if (!scene_.isolation.certify &&
            std::ranges::find(channels_, synthesis::Channel::proof) != channels_.end()) {
            throw std::invalid_argument("--channels proof: nothing is proved without --certify");
        }
        check_movie();
        check_values();
    }

    int run() {
        const auto begin = std::chrono::steady_clock::now();
        make_folder(name_.path(frames_.front()));
        if (!arguments_.movie.empty()) make_folder(arguments_.movie);
        const auto context = gpu::Context::create(backend_);
        const synthesis::Stage stage = render::choose_stage(stage_, context->info());
        if (arguments_.max_wrong && !choose_setting(*context)) return exit_check_failed;
        say("{}: {} frame{}, {}x{}, {}, step {:g}; {} ({}), {} shaders\n", scene_.title,
            frames_.size(), frames_.size() == 1 ? "" : "s", scene_.output.width,
            scene_.output.height, scene::name(scene_.isolation.method), scene_.isolation.step,
            context->info().renderer, context->info().backend, render::name(stage));
        const StopOnSignal stop;
        render_frames(*context, stop);
        if (stop.asked()) return stopped();
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
        say("{}", totals_.summary(wall));
        say("frames: {}\n", output_);
        try {
            if (!arguments_.movie.empty()) make_movie();
        } catch (const image::MovieError&) {
            if (stop.asked()) return stopped(); // a terminal's Ctrl-C reaches ffmpeg too
            throw;
        }
        return exit_done;
    }

private:
    template<class... Args> void say(fmt::format_string<Args...> format, Args&&... args) const {
        if (!arguments_.quiet) fmt::print(format, std::forward<Args>(args)...);
    }

    static int stopped() {
        fmt::print(stderr, "stopped; the frames written are whole, --resume renders the rest\n");
        return exit_interrupted;
    }

    // What can be known to fail is told before hours of drawing, not after: the movie's name and
    // rate, and values that leave their range at some frame.
    void check_movie() const {
        if (arguments_.movie.empty()) return;
        try {
            image::check_movie(arguments_.movie, movie_rate());
        } catch (const image::MovieError& error) {
            throw std::invalid_argument(fmt::format("--movie {}", error.what()));
        }
    }
    void check_values() const {
        for (const int frame : frames_) render::check_exposure(scene_, frame);
    }

    image::Rational movie_rate() const {
        return {scene_.timeline.fps.numerator, scene_.timeline.fps.denominator};
    }

    // --max-wrong: the cheapest setting that is right enough, measured on up to three of the frames
    // in a smaller picture. False if there is none.
    bool choose_setting(gpu::Context& context) {
        accuracy::Measuring measuring;
        measuring.frames = {frames_.front()};
        for (const int frame : {frames_[frames_.size() / 2], frames_.back()}) {
            if (frame != measuring.frames.back()) measuring.frames.push_back(frame);
        }
        const double shrink =
            std::min(1.0, 256.0 / std::max(scene_.output.width, scene_.output.height));
        measuring.width = std::max(1, int(shrink * scene_.output.width + 0.5));
        measuring.height = std::max(1, int(shrink * scene_.output.height + 0.5));
        measuring.stage = stage_;
        measuring.cache = accuracy::truth_cache_folder();
        std::vector<scene::Method> methods;
        if (!arguments_.method.empty()) methods.push_back(scene_.isolation.method);
        Progress progress("measuring", 1000, arguments_.quiet);
        measuring.progress = [&](const std::string& what, double part) {
            progress.show(int(1000 * part), what);
        };
        const auto measurements =
            accuracy::measure(context, scene_, accuracy::sweep(scene_, methods, {}), measuring);
        const auto found = accuracy::cheapest(measurements, *arguments_.max_wrong);
        if (!found) {
            fmt::print(stderr,
                       "--max-wrong {:g}: no setting is that accurate; isomotion accuracy {} tells "
                       "what there is\n",
                       *arguments_.max_wrong, arguments_.scene);
            return false;
        }
        const accuracy::Measurement& best = measurements[*found];
        say("{}: {:.1f} ppm wrong\n", accuracy::name(best.setting, scene_.isolation),
            best.errors.wrong_ppm());
        scene_ = accuracy::apply(best.setting, std::move(scene_));
        return true;
    }

    void render_frames(gpu::Context& context, const StopOnSignal& stop) {
        const auto warn_of_file = [](const std::string& text) {
            fmt::print(stderr, "warning: {}\n", text);
        };
        Progress progress("rendering", int(frames_.size()), arguments_.quiet);
        FrameProgress of_frame(progress, scene_.output.samples);
        render::RenderOptions options;
        options.width = scene_.output.width;
        options.height = scene_.output.height;
        options.channels = channels_;
        options.warn = warn_of_file;
        options.stage = stage_;
        options.stop = [&stop] { return stop.asked(); };
        options.progress = [&of_frame](double part) { of_frame.at(part); };
        render::Renderer renderer(context, scene_, std::move(options));
        const sequence::Sequence sequence = sequence_of(
            scene_, name_, format_, channels_, frames_, context.info(),
            render::choose_stage(stage_, context.info()), renderer.shaders_fingerprint());
        if (name_.holds_many()) recording_.emplace(name_, sequence);
        image::SequenceWriter writer(name_, format_);
        Drawn drawn{renderer, writer, {}, {}, {}};
        try {
            for (std::size_t k = 0; k < frames_.size() && !stop.asked(); ++k) {
                const int frame = frames_[k];
                of_frame.begin(int(k), frame, fs::path(name_.path(frame)).filename().string());
                add_frame(drawn, frame, sequence.making.renderer);
            }
            finish(drawn);
        } catch (const render::Stopped&) { // frames that are not whole are not written
        }
        writer.finish();
    }

    // A frame that waits for its picture, or has it.
    struct Wanted {
        int frame = 0;
        animation::Values values;
        image::Metadata metadata;
        std::string print; // of its file
        bool draws = true; // not what the frame before it shows
    };

    // What is drawn last, and which frames still wait for it.
    struct Drawn {
        render::Renderer& renderer;
        image::SequenceWriter& writer;
        std::string pixels; // the fingerprint of what it shows
        std::optional<render::Picture> picture;
        std::vector<Wanted> waiting;
    };

    void add_frame(Drawn& drawn, int frame, const std::string& machine) {
        const render::FrameInputs inputs = drawn.renderer.prepare(scene_, frame);
        const std::string& pixels = inputs.fingerprint;
        Wanted wanted{frame, inputs.values, {}, {}};
        wanted.metadata = frame_metadata(scene_, inputs.now, wanted.values, frame, "");
        wanted.print = file_fingerprint(pixels, machine, wanted.metadata);
        wanted.metadata.back().value = wanted.print;
        if (arguments_.resume && is_finished(frame, wanted.print)) return;
        // A scene that stands still is drawn once.
        wanted.draws = pixels != drawn.pixels;
        if (!wanted.draws) {
            ++totals_.reused;
            if (!drawn.waiting.empty()) return drawn.waiting.push_back(std::move(wanted));
            return write(wanted, drawn);
        }
        const bool on_its_way = render::ask(drawn.renderer, inputs);
        finish(drawn); // while this one is drawn
        drawn.pixels = pixels;
        drawn.waiting.push_back(std::move(wanted));
        if (on_its_way) return;
        drawn.picture = render::expose(drawn.renderer, inputs);
        release(drawn);
    }

    // Takes the picture that frames wait for, if any do.
    void finish(Drawn& drawn) {
        if (drawn.waiting.empty()) return;
        drawn.picture = drawn.renderer.take();
        release(drawn);
    }

    void release(Drawn& drawn) {
        totals_.add(*drawn.picture);
        warn(drawn.waiting.front().frame, *drawn.picture);
        for (Wanted& wanted : std::exchange(drawn.waiting, {})) write(wanted, drawn);
    }

    void write(Wanted& wanted, Drawn& drawn) {
        image::Frame image = drawn.picture->frame;
        image.metadata = std::move(wanted.metadata);
        std::function<void(const image::Written&)> then;
        if (recording_) {
            sequence::FrameRecord record =
                record_of(scene_, wanted.frame, wanted.values, *drawn.picture);
            if (!wanted.draws) record.drawing = 0;
            record.fingerprint = wanted.print;
            record.making = recording_->making();
            then = [this, record](const image::Written& file) mutable {
                sequence::add(file, record);
                recording_->record(record);
            };
        }
        drawn.writer.submit(wanted.frame, std::move(image), std::move(then));
    }

    // Pixels, file format and everything else that the file records.
    std::string file_fingerprint(const std::string& pixels, const std::string& machine,
                                 const image::Metadata& metadata) const {
        base::Fingerprint print;
        print.add(pixels).add(machine).add(ISOMOTION_VERSION).add(std::to_string(int(format_)));
        for (const auto& entry : metadata) print.add(entry.name).add(image::to_text(entry.value));
        return print.text();
    }

    // Whether the file is what these settings would write, by the records of earlier runs.
    bool is_finished(int frame, const std::string& print) {
        const auto record =
            recording_ ? sequence::find_record(recording_->manifest(), frame) : std::nullopt;
        const auto found = sequence::standing(name_.path(frame), record, print);
        totals_.note(frame, found);
        if (found != sequence::Standing::whole) return false;
        if (record->making != recording_->making()) { // the same picture of a changed scene
            sequence::FrameRecord again = *record;
            again.making = recording_->making();
            recording_->record(again);
        }
        return true;
    }

    void warn(int frame, const render::Picture& picture) const {
        for (const auto verdict : {render::Verdict::nan, render::Verdict::step_limit}) {
            const auto count = picture.verdicts[std::size_t(verdict)];
            if (count == 0) continue;
            fmt::print(stderr, "warning: frame {}: {} {}{} ended with the verdict {}\n", frame,
                       count, scene_.output.samples == 1 ? "pixel" : "ray", count == 1 ? "" : "s",
                       render::verdict_names[std::size_t(verdict)]);
        }
    }

    void make_movie() const {
        std::vector<fs::path> pictures;
        for (const int frame : frames_) pictures.push_back(name_.path(frame));
        image::write_movie(arguments_.movie, pictures, movie_rate());
        say("movie: {}\n", arguments_.movie);
    }

    const RenderArguments& arguments_;
    scene::Scene scene_;
    gpu::Backend backend_;
    render::StageChoice stage_;
    std::vector<synthesis::Channel> channels_;
    std::vector<int> frames_;
    std::string output_;
    image::SequenceName name_;
    image::Format format_;
    // Of a sequence; held until its movie is made, too, so that nobody replaces its frames.
    std::optional<sequence::Recording> recording_;
    RenderTotals totals_;
};

} // namespace

void check_render(const RenderArguments& arguments) { RenderJob{arguments}; }

void add_render(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<RenderArguments>();
    RenderArguments& a = *arguments;
    CLI::App* command = app.add_subcommand("render", "render frames of a scene into image files");
    add_sequence_options(*command, a);
    add_picture_options(*command, a);
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return RenderJob(*arguments).run(); }; });
}

} // namespace isomotion::app
