// Renders a scene's frames to files, with a manifest that describes them, and joins them to movies.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <isomotion/error.h>

#include "audit/audit.h"
#include "gpu/context.h"
#include "image/encode.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "sequence/frame_status.h"
#include "sequence/manifest_writer.h"
#include "sequence/names/sequence_name.h"
#include "sequence/pace.h"

namespace isomotion::sequence {

struct ExportOptions {
    std::string output;       // out/name.####.png or .exr
    std::vector<int> frames;  // at least one
    std::vector<int> part_of; // frames of the sequence that `frames` are a part of; none: these
    std::vector<shader::Channel> channels; // for an EXR, besides the picture
    int bits = 8;                          // for a PNG: 8 or 16
    render::StageChoice stage = render::StageChoice::fragment;
    std::optional<int> audit; // rays per frame; unset: as many as are cheap; 0: no audit
    bool resume = false;      // keep files that these options would render again
    std::vector<std::filesystem::path> movies; // .mp4, .webm or .gif
};

struct ExportProgress {
    int done = 0; // frames before this one
    int frame = 0;
    std::filesystem::path file;
    double part = 0;        // of the frame that is drawn; 1 while the last one is written
    Pace::Seconds passed{}; // since it was begun
    std::optional<Pace::Seconds> left{};
    // A frame before that was on its way, and needs more than was sent for it; `passed` is of that.
    std::optional<int> landing{};
};

// Each may be empty. The exporting thread calls them.
struct ExportWatcher {
    std::function<bool()> stop;
    std::function<void(const std::string&)> warn;
    std::function<void(const ExportProgress&)> progress;
};

struct ExportTotals {
    std::array<std::int64_t, render::verdict_names.size()> verdicts{}; // rays
    render::ProofCounts proofs{};                                      // pixels
    render::RayCounts rays{};
    std::int64_t without_colour = 0; // pixels whose colour is infinite or NaN
    std::chrono::duration<double> drawing{};
    audit::Findings audit;     // of the frames drawn
    int drawn = 0, reused = 0; // frames; reused ones show the same as the frame before
    std::map<FrameStatus, std::vector<int>> found; // with `resume`: the frames' status before
    bool stopped = false; // the watcher requested it; files already written are complete
};

class Exporter {
public:
    // Throws for every failure that can be foreseen before drawing: an Error (setting) for options
    // that contradict each other, which begins with the name of one, base::InputError for the
    // output's name or a value out of its range at some frame, image::ImageError for the output's
    // extension.
    Exporter(scene::Scene scene, ExportOptions options);

    const scene::Scene& scene() const { return scene_; }
    const ExportOptions& options() const { return options_; }
    // Changes the settings of each surface's isolation, the first one's first.
    void choose(std::span<const scene::Isolation> settings);

    // Makes the folders of the frames and of the movies, as export_frames() does. Throws FileError.
    void make_folders() const;

    // Throws the errors of Renderer, FileError, and an Error (input) if another process is
    // rendering another sequence into these files. This object locks a sequence's manifest until it
    // is destroyed, so that nobody replaces the frames before their movie is made.
    ExportTotals export_frames(gpu::Context& context, const ExportWatcher& watcher = {});

    // Joins the exported frames to each movie, in the requested order. Returns false if stopped.
    // Throws the errors of sequence::write_movie(), and an Error (file) for a frame's file that is
    // no picture any more.
    bool write_movies(const ExportWatcher& watcher = {}) const;

private:
    scene::Scene scene_;
    ExportOptions options_;
    SequenceName name_;
    image::Format format_;
    std::optional<ManifestWriter> manifest_;
};

} // namespace isomotion::sequence
