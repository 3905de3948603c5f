#include "sequence/exporter.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "animation/frame_range.h"
#include "base/file.h"
#include "render/exposure.h"
#include "sequence/describe.h"
#include "sequence/manifest.h"
#include "sequence/movies/movie.h"
#include "sequence/writer.h"

namespace isomotion::sequence {
namespace fs = std::filesystem;
namespace {

void make_folder_of(const fs::path& file) {
    const fs::path folder = file.parent_path();
    if (folder.empty()) return;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error && !fs::is_directory(folder)) {
        throw base::FileError(folder, "the folder cannot be created", error.value());
    }
}

image::Rational movie_rate(const scene::Scene& scene) {
    return {scene.timeline.fps.numerator, scene.timeline.fps.denominator};
}

bool stopped(const ExportWatcher& watcher) { return watcher.stop && watcher.stop(); }

void check_options(const scene::Scene& scene, const ExportOptions& options, image::Format format) {
    if (options.frames.empty()) throw Error(Error::Code::setting, "frames: name at least one");
    if (!options.part_of.empty()) {
        const std::set<int> all(options.part_of.begin(), options.part_of.end());
        for (const int frame : options.frames) {
            if (all.contains(frame)) continue;
            throw Error(Error::Code::setting,
                        fmt::format("part-of {}: frame {} is to be rendered and is not among "
                                    "them; name all frames of the sequence",
                                    animation::frame_range(options.part_of), frame));
        }
    }
    if (format == image::Format::exr && options.bits != 8) {
        throw Error(Error::Code::setting, "bits is of a PNG; an EXR holds half floats");
    }
    if (format != image::Format::exr && !options.channels.empty()) {
        throw Error(Error::Code::setting,
                    fmt::format("channels: a PNG holds the picture alone; write an EXR: {}",
                                fs::path(options.output).replace_extension(".exr").string()));
    }
    if (!scene.surfaces.front().isolation.certify &&
        std::ranges::find(options.channels, shader::Channel::proof) != options.channels.end()) {
        throw Error(Error::Code::setting,
                    "channels proof: nothing is proved without isolation.certify");
    }
    try {
        for (const fs::path& movie : options.movies) check_movie(movie, movie_rate(scene));
    } catch (const Error& error) {
        throw Error(Error::Code::setting, fmt::format("movie {}", error.what()));
    }
}

// What the manifest says was asked for.
const std::vector<int>& asked(const ExportOptions& options) {
    return options.part_of.empty() ? options.frames : options.part_of;
}

// A frame that waits for its picture, or has it.
struct PendingFrame {
    int frame = 0;
    std::shared_ptr<const scene::SceneAt> now;
    bool is_audited = false;
    std::shared_ptr<const elements::ElementGrid> grid{}; // of an audited one, if it has a grid
    scene::Aim aim{};                                    // of its first picture
    image::Metadata metadata{};
    std::string fingerprint{}; // of its file
    bool draws = true;         // not what the frame before it shows
};

// Audits what is drawn, on the thread that writes.
class Auditing {
public:
    explicit Auditing(const scene::Scene& scene)
        : scene_(scene)
        , auditor_(scene)
        , operations_(auditor_.operations_at_a_point()) {}

    // None where no ray was asked for.
    std::optional<AuditCounts> hold(int frame, const scene::SceneAt& now, const scene::Aim& aim,
                                    std::shared_ptr<const elements::ElementGrid> grid,
                                    std::span<const render::Ending> endings,
                                    const std::function<bool()>& stop) {
        if (endings.empty()) return std::nullopt;
        const scene::Output& output = scene_.output;
        const audit::Findings found = auditor_.hold(frame, now, aim, output.width, output.height,
                                                    endings, stop, std::move(grid));
        const std::lock_guard lock(mutex_);
        all_.add(found);
        seconds_a_ray_ = auditor_.seconds_a_ray();
        return AuditCounts{found.rays - found.wrong, found.wrong, found.undecided};
    }

    int affordable(double drawing_seconds) const {
        const std::lock_guard lock(mutex_);
        return audit::affordable(drawing_seconds, seconds_a_ray_, operations_);
    }

    audit::Findings all() const {
        const std::lock_guard lock(mutex_);
        return all_;
    }

private:
    const scene::Scene& scene_;
    audit::Auditor auditor_;   // the writing thread's
    const double operations_;  // of the formula
    mutable std::mutex mutex_; // of what follows
    audit::Findings all_;
    double seconds_a_ray_ = 0;
};

// One run over the frames. A frame is drawn while the one before is read back, and encoded and
// written by another thread after that.
class Run {
public:
    // Begins or joins the manifest, if there is to be one.
    Run(gpu::Context& context, const scene::Scene& scene, const ExportOptions& options,
        const SequenceName& name, image::Format format, const ExportWatcher& watcher,
        std::optional<ManifestWriter>& manifest)
        : scene_(scene)
        , options_(options)
        , name_(name)
        , format_(format)
        , watcher_(watcher)
        , auditing_(scene)
        , renderer_(context, scene, render_options())
        , sequence_(sequence_of(scene, name, format, options.channels, asked(options),
                                context.info(), render::choose_stage(options.stage, context.info()),
                                renderer_.shaders_fingerprint()))
        , manifest_(name.holds_many() ? &manifest.emplace(name, sequence_) : nullptr)
        , writer_(name, format) {}

    ExportTotals run() {
        try {
            for (std::size_t k = 0; k < options_.frames.size() && !stopped(watcher_); ++k) {
                begin(int(k));
                add(options_.frames[k]);
            }
            finish();
            tell_of_frame(1);              // only writing is left
        } catch (const render::Stopped&) { // frames that are not whole are not written
        }
        writer_.finish();
        totals_.audit = auditing_.all();
        warn_of_audit();
        totals_.stopped = stopped(watcher_);
        if (!totals_.stopped) expect_unchanged_elements();
        return totals_;
    }

private:
    render::RenderOptions render_options() {
        render::RenderOptions options;
        options.width = scene_.output.width;
        options.height = scene_.output.height;
        options.channels = options_.channels;
        options.stage = options_.stage;
        options.tells_endings = options_.audit != 0;
        options.warn = [this](const std::string& text) { warn(text); };
        options.stop = [this] { return stopped(watcher_); };
        options.progress = [this](double part) { tell(part); };
        return options;
    }

    // Files may change after their frames were drawn.
    void expect_unchanged_elements() const {
        for (const scene::Surface& surface : scene_.surfaces) {
            for (const animation::Array& array : surface.animation.arrays()) {
                if (array.samples) array.samples->source().expect_unchanged();
            }
        }
    }

    void warn(const std::string& text) const {
        if (watcher_.warn) watcher_.warn(text);
    }

    void begin(int done) {
        const int frame = options_.frames[std::size_t(done)];
        progress_ = {.done = done, .frame = frame, .file = name_.path(frame)};
        begin_ = std::chrono::steady_clock::now();
        pace_ = {};
        picture_ = 0;
        part_ = 0;
        if (watcher_.progress) watcher_.progress(progress_);
    }

    // `part` of one of the pictures that the frame is the mean of.
    void tell(double part) {
        if (landing_since_) {
            tell_of_landing(*landing_since_);
            return;
        }
        if (part < part_) ++picture_;
        part_ = part;
        tell_of_frame(std::min((picture_ + part) / scene_.output.samples, 1.0));
    }

    void tell_of_frame(double part) {
        progress_.part = part;
        progress_.passed = std::chrono::steady_clock::now() - begin_;
        pace_.note(part, progress_.passed);
        progress_.left = pace_.left(progress_.passed);
        if (watcher_.progress) watcher_.progress(progress_);
    }

    // A picture that needs more than was sent on its way is drawn when it is taken, which may take
    // long. By then the next frame may have begun.
    void tell_of_landing(std::chrono::steady_clock::time_point since) {
        ExportProgress now = progress_;
        now.landing = waiting_.front().frame;
        now.passed = std::chrono::steady_clock::now() - since;
        if (watcher_.progress) watcher_.progress(now);
    }

    // How many rays of the next frame to audit.
    int rays_to_audit() const {
        const int pixels = scene_.output.width * scene_.output.height;
        const double drawing = totals_.drawn > 0 ? totals_.drawing.count() / totals_.drawn : 0;
        return std::min(pixels, options_.audit.value_or(auditing_.affordable(drawing)));
    }

    void add(int frame) {
        render::FrameInputs inputs = renderer_.prepare(scene_, frame);
        const std::string& pixels = inputs.fingerprint;
        PendingFrame next{frame, std::make_shared<const scene::SceneAt>(std::move(inputs.now))};
        next.aim = inputs.pictures.front().aim;
        inputs.pictures.front().endings_of = audit::pixels_of_frame(
            scene_.output.width, scene_.output.height, rays_to_audit(), frame);
        if (!inputs.pictures.front().endings_of.empty()) {
            next.is_audited = true;
            next.grid = render::grid(inputs.pictures.front().surfaces.front());
        }
        next.metadata = frame_metadata(scene_, *next.now, frame, format_);
        next.fingerprint =
            file_fingerprint(pixels, sequence_.provenance.renderer, format_, next.metadata);
        next.metadata.back().value = next.fingerprint;
        if (options_.resume && is_finished(next)) return;
        // A scene that stands still is drawn once.
        next.draws = pixels != drawn_;
        if (!next.draws) {
            ++totals_.reused;
            if (!waiting_.empty()) return waiting_.push_back(std::move(next));
            return write(next);
        }
        const bool on_its_way = render::ask(renderer_, inputs);
        finish(); // while this one is drawn
        drawn_ = pixels;
        waiting_.push_back(std::move(next));
        if (on_its_way) return;
        picture_drawn_ = render::expose(renderer_, inputs);
        release();
    }

    // Takes the picture that frames wait for, if any do.
    void finish() {
        if (waiting_.empty()) return;
        landing_since_ = std::chrono::steady_clock::now();
        picture_drawn_ = renderer_.take();
        landing_since_.reset();
        release();
    }

    void release() {
        const render::Picture& picture = picture_drawn_;
        for (std::size_t v = 0; v < totals_.verdicts.size(); ++v) {
            totals_.verdicts[v] += picture.verdicts[v];
        }
        for (std::size_t p = 0; p < totals_.proofs.size(); ++p) {
            totals_.proofs[p] += picture.proofs[p];
        }
        render::add(picture.rays, totals_.rays);
        const std::int64_t without_colour = image::count_without_colour(picture.frame);
        totals_.without_colour += without_colour;
        totals_.drawing += picture.drawing;
        ++totals_.drawn;
        warn_of_verdicts(waiting_.front().frame, picture);
        if (without_colour > 0) {
            warn(fmt::format("frame {}: the colour of {} pixel{} is infinite or no number",
                             waiting_.front().frame, without_colour,
                             without_colour == 1 ? "" : "s"));
        }
        for (PendingFrame& frame : std::exchange(waiting_, {})) write(frame);
    }

    void warn_of_verdicts(int frame, const render::Picture& picture) const {
        for (const auto verdict : {render::Verdict::nan, render::Verdict::step_limit}) {
            const auto count = picture.verdicts[std::size_t(verdict)];
            if (count == 0) continue;
            warn(fmt::format("frame {}: {} {}{} ended with the verdict {}", frame, count,
                             scene_.output.samples == 1 ? "pixel" : "ray", count == 1 ? "" : "s",
                             render::verdict_names[std::size_t(verdict)]));
        }
        for (const auto& [kind, what] :
             {std::pair(render::RayKind::shadow, "shadow ray{} stayed undecided, and let light by"),
              std::pair(render::RayKind::path, "mirrored or refracted ray{} stayed undecided")}) {
            const render::RayCount& of = picture.rays[std::size_t(kind)];
            if (of.undecided == 0) continue;
            warn(fmt::format("frame {}: {} {}; one is at pixel ({}, {})", frame, of.undecided,
                             fmt::format(fmt::runtime(what), of.undecided == 1 ? "" : "s"),
                             of.column, of.row));
        }
    }

    void warn_of_audit() const {
        for (const audit::WrongPixel& pixel : totals_.audit.examples) {
            warn(fmt::format("frame {}, pixel ({}, {}): {}", pixel.frame, pixel.column, pixel.row,
                             roots::words(pixel.fault)));
        }
        if (totals_.audit.wrong == 0) return;
        const bool by_bounds = scene_.surfaces.front().isolation.method == scene::Method::affine;
        warn(fmt::format("the picture is wrong in places; --method {} goes by bounds alone",
                         scene::name(by_bounds ? scene::Method::interval : scene::Method::affine)));
    }

    void write(PendingFrame& pending) {
        image::Frame image = picture_drawn_.frame;
        image.metadata = std::move(pending.metadata);
        std::function<std::optional<AuditCounts>()> audit = [] { return std::nullopt; };
        if (pending.draws && pending.is_audited) {
            audit = [this, frame = pending.frame, now = pending.now, aim = pending.aim,
                     grid = std::move(pending.grid), endings = picture_drawn_.endings] {
                return auditing_.hold(frame, *now, aim, grid, endings, watcher_.stop);
            };
        }
        if (!manifest_) {
            writer_.submit(pending.frame, std::move(image),
                           [audit](const WrittenFile&) { audit(); });
            return;
        }
        FrameRecord record = record_of(scene_, pending.frame, *pending.now, picture_drawn_);
        if (!pending.draws) record.drawing = 0;
        record.fingerprint = pending.fingerprint;
        record.provenance = sequence_.provenance;
        const auto then = [manifest = manifest_, record, audit](const WrittenFile& file) mutable {
            sequence::add(file, record);
            record.audit = audit();
            manifest->record(record);
        };
        writer_.submit(pending.frame, std::move(image), then);
    }

    // Whether the file is what these options would write, by the records of earlier runs.
    bool is_finished(const PendingFrame& pending) {
        const int frame = pending.frame;
        const auto record = manifest_ ? find_record(name_, frame) : std::nullopt;
        const FrameStatus status =
            frame_status(name_.path(frame), record, pending.fingerprint, ISOMOTION_VERSION);
        totals_.found[status].push_back(frame);
        if (status != FrameStatus::whole || !record) return false;
        if (record->provenance != sequence_.provenance) { // of a changed scene, as it was here
            FrameRecord again = *record;
            again.provenance = sequence_.provenance;
            manifest_->record(again);
        }
        return true;
    }

    const scene::Scene& scene_;
    const ExportOptions& options_;
    const SequenceName& name_;
    const image::Format format_;
    const ExportWatcher& watcher_;

    Auditing auditing_;
    render::Renderer renderer_;
    const Sequence sequence_;
    const ManifestWriter* const manifest_; // none for a name that holds one frame
    ExportTotals totals_;

    ExportProgress progress_;
    std::chrono::steady_clock::time_point begin_{}; // of the frame
    Pace pace_;
    int picture_ = 0;                                                    // of the frame's
    double part_ = 0;                                                    // of the picture
    std::optional<std::chrono::steady_clock::time_point> landing_since_; // of a frame before

    std::string drawn_;                 // fingerprint of the picture drawn last or on its way
    render::Picture picture_drawn_;     // last
    std::vector<PendingFrame> waiting_; // for the picture on its way

    SequenceWriter writer_; // last: its thread uses the above
};

} // namespace

Exporter::Exporter(scene::Scene scene, ExportOptions options)
    : scene_(std::move(scene))
    , options_(std::move(options))
    , name_(SequenceName::parse(options_.output))
    , format_(image::format_of(options_.output, options_.bits == 16 ? image::PngDepth::bits16
                                                                    : image::PngDepth::bits8)) {
    name_.check_holds(options_.frames.size());
    check_options(scene_, options_, format_);
    for (const int frame : options_.frames) render::check_exposure(scene_, frame);
}

void Exporter::choose(std::span<const scene::Isolation> settings) {
    for (std::size_t k = 0; k < settings.size(); ++k) scene_.surfaces[k].isolation = settings[k];
}

void Exporter::make_folders() const {
    make_folder_of(name_.path(options_.frames.front()));
    for (const fs::path& movie : options_.movies) make_folder_of(movie);
}

ExportTotals Exporter::export_frames(gpu::Context& context, const ExportWatcher& watcher) {
    if (!options_.movies.empty()) expect_ffmpeg(); // not after hours of drawing
    make_folders();
    manifest_.reset();
    return Run(context, scene_, options_, name_, format_, watcher, manifest_).run();
}

bool Exporter::write_movies(const ExportWatcher& watcher) const {
    std::vector<fs::path> pictures;
    for (const int frame : options_.frames) pictures.push_back(name_.path(frame));
    try {
        return std::ranges::all_of(options_.movies, [&](const fs::path& movie) {
            return write_movie(movie, pictures, movie_rate(scene_), watcher.stop);
        });
    } catch (const image::ImageError& error) {
        throw Error(Error::Code::file, error.what());
    }
}

} // namespace isomotion::sequence
