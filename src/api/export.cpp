#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "animation/frame_range.h"
#include "api/drawing/parts.h"
#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "sequence/exporter.h"
#include "sequence/inputs.h"
#include "sequence/verification.h"

namespace isomotion {
namespace {

sequence::ExportOptions options_of(const scene::Scene& scene, const ExportSettings& settings) {
    if (settings.bits != 8 && settings.bits != 16)
        throw Error(Error::Code::input, "a PNG has 8 or 16 bits");
    constexpr int most_audited = 1'000'000;
    if (settings.audit.value_or(0) < 0 || settings.audit.value_or(0) > most_audited) {
        throw Error(Error::Code::input,
                    fmt::format("an audit takes 0 to {} rays of each frame", most_audited));
    }
    sequence::ExportOptions options;
    options.output = settings.output;
    options.frames = animation::parse_frame_range(
        settings.frames.empty() ? fmt::format("1-{}", scene.timeline.frames) : settings.frames);
    options.channels = api::channels_of(settings.channels);
    options.bits = settings.bits;
    options.audit = settings.audit;
    options.resume = settings.resume;
    options.movies = settings.movies;
    return options;
}

sequence::ExportWatcher watcher_of(const Watcher& watcher, std::size_t frames) {
    sequence::ExportWatcher all{.stop = watcher.stop, .warn = watcher.warn, .progress = {}};
    if (watcher.progress) {
        all.progress = [tell = watcher.progress, frames](const sequence::ExportProgress& now) {
            tell(now.file.string(), (now.done + now.part) / double(frames));
        };
    }
    return all;
}

Exported exported(const sequence::ExportTotals& totals) {
    const auto kept = totals.found.find(sequence::FrameStatus::whole);
    return {.drawn = totals.drawn,
            .reused = totals.reused,
            .kept = kept == totals.found.end() ? 0 : int(kept->second.size()),
            .hits = totals.verdicts[std::size_t(render::Verdict::hit)],
            .wrong = totals.audit.wrong,
            .audited = totals.audit.rays,
            .stopped = totals.stopped};
}

} // namespace

Exported export_frames(Device& device, const Scene& scene, const ExportSettings& settings,
                       const Watcher& watcher) {
    return api::with_errors([&] {
        const scene::Scene& all = scene.parts().scene;
        sequence::Exporter exporter(all, options_of(all, settings));
        const sequence::Inputs inputs(scene.files());
        inputs.expect_apart("output", sequence::SequenceName::parse(settings.output));
        for (const auto& movie : settings.movies) inputs.expect_apart("movies", movie);
        const auto all_frames = watcher_of(watcher, exporter.options().frames.size());
        Exported result = exported(exporter.export_frames(*device.parts().context, all_frames));
        if (!result.stopped) result.stopped = !exporter.write_movies(all_frames);
        return result;
    });
}

Verified verify(const std::filesystem::path& manifest, bool pixels) {
    return api::with_errors([&] {
        const sequence::Verification found = sequence::verify(manifest, {.pixels = pixels});
        return Verified{found.is_whole(), found.missing, found.changed};
    });
}

} // namespace isomotion
