#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "animation/frame_range.h"
#include "api/drawing/parts.h"
#include "api/drawing/statistics.h"
#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "isomotion/sequence.h"
#include "probe/found_bounds.h"
#include "probe/sight.h"
#include "scene/method.h"
#include "scene/surfaces.h"
#include "sequence/exporter.h"
#include "sequence/inputs.h"
#include "sequence/movies/movie.h"
#include "sequence/verification.h"

namespace isomotion {
namespace {

using Warn = std::function<void(const std::string&)>;

std::string frames_text(std::size_t count) {
    return fmt::format("{} frame{}", count, count == 1 ? "" : "s");
}

sequence::ExportOptions options_of(const scene::Scene& scene, const ExportSettings& settings) {
    if (settings.bits != 8 && settings.bits != 16)
        throw Error(Error::Code::setting, "bits: a PNG has 8 or 16");
    if (settings.audit.value_or(0) < 0 || settings.audit.value_or(0) > most_audited) {
        throw Error(Error::Code::setting,
                    fmt::format("audit: 0 to {} rays of each frame", most_audited));
    }
    sequence::ExportOptions options;
    options.stage = render::parse_stage(settings.stage);
    options.channels = api::channels_of(settings.channels);
    options.frames = settings.frames;
    for (int k = 1; settings.frames.empty() && k <= scene.timeline.frames; ++k)
        options.frames.push_back(k);
    for (const int frame : options.frames) api::checked_frame(frame);
    options.part_of = settings.part_of;
    options.output = settings.output;
    if (options.output.empty()) {
        options.output =
            fmt::format("out/{}.####.png", sequence::stem_of_frames(scene.file.stem().string()));
    }
    options.bits = settings.bits;
    options.audit = settings.audit;
    options.resume = settings.resume;
    options.movies = settings.movies;
    return options;
}

sequence::Exporter exporter_of(const Scene& scene, const ExportSettings& settings) {
    sequence::ExportOptions options = options_of(scene.parts().scene, settings);
    const sequence::Inputs inputs(scene.files());
    inputs.expect_apart("output", sequence::SequenceName::parse(options.output));
    for (const auto& movie : settings.movies) inputs.expect_apart("movie", movie);
    return {scene.parts().scene, std::move(options)};
}

void warn_of_bounds(const sequence::Exporter& exporter, const Warn& warn) {
    const scene::Scene& scene = exporter.scene();
    const int last = std::ranges::max(exporter.options().frames);
    if (!warn || !probe::are_bounds_found(scene) || last <= scene.timeline.frames) return;
    warn(fmt::format("frames beyond {0} may be cut: bounds were found for frames 1 to {0}; --set "
                     "time.frames={1} finds them for all",
                     scene.timeline.frames, last));
}

// What is known of each surface at the first frame asked for, with what tells it from others.
std::vector<std::pair<std::string, probe::Sight>> sights_of(const sequence::Exporter& exporter) {
    const scene::Scene& scene = exporter.scene();
    const int frame = exporter.options().frames.front();
    const scene::SceneAt now = scene::at_frame(scene, frame);
    std::vector<std::pair<std::string, probe::Sight>> sights;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        const scene::OneSurface one(scene, k);
        sights.emplace_back(one.is_alone() ? "" : fmt::format("surface '{}': ", one.surface.label),
                            probe::sight(one, {now, k}));
    }
    return sights;
}

// Rays that end undecided may have missed something, unless F is proved to have no zero.
std::string why_no_hit(const Exported& totals, const std::string& whose,
                       const probe::Sight& sight) {
    const std::int64_t undecided = totals.not_numbers + totals.step_limits;
    if (undecided > 0 && !sight.values)
        return fmt::format("no ray is known to hit anything: {} ended undecided", undecided);
    return fmt::format("no ray hits anything: {}{}", whose, probe::why_nothing_is_seen(sight));
}

sequence::ExportWatcher watcher_of(const ExportWatcher& watcher, std::size_t frames) {
    sequence::ExportWatcher all{.stop = watcher.stop, .warn = watcher.warn, .progress = {}};
    if (watcher.progress) {
        all.progress = [tell = watcher.progress, frames](const sequence::ExportProgress& now) {
            ExportProgress told{.count = int(frames),
                                .done = now.done,
                                .frame = now.frame,
                                .file = now.file,
                                .part = now.part,
                                .seconds = now.passed.count(),
                                .landing = now.landing};
            if (now.left) told.left = now.left->count();
            tell(told);
        };
    }
    return all;
}

Exported exported(const sequence::ExportTotals& totals) {
    Exported all;
    static_cast<RayStatistics&>(all) =
        api::statistics_of(totals.verdicts, totals.rays, totals.proofs, totals.drawing);
    all.drawn = totals.drawn;
    all.reused = totals.reused;
    for (const auto& [status, frames] : totals.found) {
        if (status == sequence::FrameStatus::whole) {
            all.kept = int(frames.size());
        } else {
            all.not_kept.push_back({std::string(sequence::name(status)), frames});
        }
    }
    all.audited = totals.audit.rays;
    all.wrong = totals.audit.wrong;
    all.undecided = totals.audit.undecided;
    all.without_colour = totals.without_colour;
    all.stopped = totals.stopped;
    return all;
}

std::string drawing_summary(const Exported& totals, double all_seconds) {
    const std::int64_t rays = totals.rays(), evaluations = totals.evaluations();
    std::string text =
        fmt::format("drawn {} in {:.2f} s ({:.1f} ms each, {:.1f} evaluations a ray); all "
                    "of it took {:.2f} s, {:.2f} times the drawing\n",
                    totals.drawn, totals.seconds, 1e3 * totals.seconds / totals.drawn,
                    double(evaluations) / double(rays), all_seconds, all_seconds / totals.seconds);
    text += "rays:";
    const api::Verdicts verdicts = api::verdicts_of(totals);
    for (std::size_t v = 0; v < verdicts.size(); ++v)
        text += fmt::format("{} {} {}", v == 0 ? "" : ",", verdicts[v], render::verdict_names[v]);
    text += "\n";
    const render::RayCounts kinds = api::rays_of(totals);
    if (kinds[std::size_t(render::RayKind::eye)].evaluations < evaluations)
        text += "evaluations: " + render::words(kinds, rays) + "\n";
    if (totals.without_colour > 0) {
        text +=
            fmt::format("{} pixels whose colour is infinite or no number\n", totals.without_colour);
    }
    if (!totals.proofs.empty()) text += render::summary(api::proofs_of(totals)) + "\n";
    return text;
}

} // namespace

std::string Exported::summary(double all_seconds) const {
    std::string text;
    if (drawn > 0) text += drawing_summary(*this, all_seconds);
    if (reused > 0) text += frames_text(std::size_t(reused)) + " equal to the one before\n";
    if (audited + undecided > 0) {
        text += audit::words({.rays = audited, .undecided = undecided, .wrong = wrong}, drawn);
        text += "\n";
    }
    if (kept > 0) text += frames_text(std::size_t(kept)) + " kept from an earlier run\n";
    std::string reasons;
    for (const auto& [why, frames] : not_kept) {
        reasons += fmt::format("{}{} {} ({})", reasons.empty() ? "" : "; ", frames.size(), why,
                               animation::frame_range(frames));
    }
    if (!reasons.empty()) text += fmt::format("not kept: {}\n", reasons);
    return text;
}

struct Exporter::Parts {
    sequence::Exporter exporter;
};

Exporter::Exporter(const Scene& scene, const ExportSettings& settings, const Warn& warn) {
    parts_ = api::with_errors(
        [&] { return std::make_unique<Parts>(Parts{exporter_of(scene, settings)}); });
    warn_of_bounds(parts_->exporter, warn);
}

Exporter::Exporter(Exporter&&) noexcept = default;
Exporter& Exporter::operator=(Exporter&&) noexcept = default;
Exporter::~Exporter() = default;

const std::vector<int>& Exporter::frames() const { return parts_->exporter.options().frames; }
const std::string& Exporter::output() const { return parts_->exporter.options().output; }

std::string Exporter::plan(const Device& device) const {
    return api::with_errors([&] {
        const scene::Scene& scene = parts_->exporter.scene();
        const scene::Isolation& isolation = scene.surfaces.front().isolation;
        const gpu::ContextInfo& driver = device.parts().context->info();
        const auto stage = render::choose_stage(parts_->exporter.options().stage, driver);
        return fmt::format("{}: {}, {}x{}, {}, step {:g}; {} ({}), {} shaders", scene.title,
                           frames_text(frames().size()), scene.output.width, scene.output.height,
                           scene::name(isolation.method), isolation.step, driver.renderer,
                           driver.backend, render::name(stage));
    });
}

void Exporter::prepare() const {
    api::with_errors([&] {
        parts_->exporter.make_folders();
        if (!parts_->exporter.options().movies.empty()) sequence::expect_ffmpeg();
    });
}

Exported Exporter::write_frames(Device& device, const ExportWatcher& watcher) {
    return api::with_errors([&] {
        sequence::Exporter& exporter = parts_->exporter;
        const auto sights = sights_of(exporter);
        for (const auto& [whose, sight] : sights) {
            for (const std::string& slip : probe::slips(sight)) {
                if (watcher.warn) watcher.warn(whose + slip);
            }
        }
        Exported totals = exported(
            exporter.export_frames(*device.parts().context, watcher_of(watcher, frames().size())));
        // Frames that an earlier run wrote may show something.
        const bool is_all = std::size_t(totals.drawn + totals.reused) == frames().size();
        const bool has_hits = totals.hits + totals.zero_gradients > 0;
        if (watcher.warn && !totals.stopped && is_all && !has_hits)
            watcher.warn(why_no_hit(totals, sights.front().first, sights.front().second));
        return totals;
    });
}

bool Exporter::write_movies(const std::function<bool()>& stop) const {
    return api::with_errors(
        [&] { return parts_->exporter.write_movies({.stop = stop, .warn = {}, .progress = {}}); });
}

Exported export_frames(Device& device, const Scene& scene, const ExportSettings& settings,
                       const ExportWatcher& watcher) {
    Exporter exporter(scene, settings, watcher.warn);
    Exported result = exporter.write_frames(device, watcher);
    if (!result.stopped) result.stopped = !exporter.write_movies(watcher.stop);
    return result;
}

Verified verify(const std::filesystem::path& manifest, bool pixels) {
    return api::with_errors([&] {
        const sequence::Verification found = sequence::verify(manifest, {.pixels = pixels});
        return Verified{found.is_whole(), found.missing, found.changed};
    });
}

} // namespace isomotion
