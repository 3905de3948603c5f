// A scene's frames rendered into files, with the manifest that says what they are, and joined to a
// movie.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "audit/audit.h"
#include "gpu/context.h"
#include "image/encode.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "sequence/frame_status.h"
#include "sequence/manifest_writer.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::sequence {

// Options that contradict one another; the message begins with the name of one.
class OptionError : public std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

struct ExportOptions {
    std::string output;                       // out/name.####.png or .exr
    std::vector<int> frames;                  // at least one
    std::vector<synthesis::Channel> channels; // of an EXR, beside the picture
    int bits = 8;                             // of a PNG: 8 or 16
    render::StageChoice stage = render::StageChoice::fragment;
    std::optional<int> audit; // rays of each frame; none: as many as are cheap; 0: no audit
    bool resume = false;      // keep files that these options would render again
    std::vector<std::filesystem::path> movies; // .mp4, .webm or .gif
};

struct ExportProgress {
    int done = 0; // frames before this one
    int frame = 0;
    std::filesystem::path file;
    double part = 0; // of the frame that is drawn
};

// Each may be empty; called from the exporting thread.
struct ExportWatcher {
    std::function<bool()> stop;
    std::function<void(const std::string&)> warn;
    std::function<void(const ExportProgress&)> progress;
};

struct ExportTotals {
    std::array<std::int64_t, render::verdict_names.size()> verdicts{}; // rays
    render::ProofCounts proofs{};                                      // pixels
    std::int64_t evaluations = 0;
    std::int64_t without_colour = 0; // pixels whose colour is infinite or no number
    std::chrono::duration<double> drawing{};
    audit::Findings audit;     // of the frames drawn
    int drawn = 0, reused = 0; // frames; those reused show what the one before did
    std::map<FrameStatus, std::vector<int>> found; // with `resume`: how frames stood before
    bool stopped = false; // the watcher asked for it; what is written is whole
};

class Exporter {
public:
    // Throws for everything that can be known to fail before anything is drawn: OptionError,
    // base::InputError for the output's name or a value that leaves its range at some frame,
    // image::ImageError for the output's extension.
    Exporter(scene::Scene scene, ExportOptions options);

    const scene::Scene& scene() const { return scene_; }
    const ExportOptions& options() const { return options_; }
    // Other settings of the scene's isolation.
    void choose(const scene::Isolation& isolation) { scene_.isolation = isolation; }

    // Makes the folders of the frames and of the movies, as export_frames() does. Throws FileError.
    void make_folders() const;

    // Throws what Renderer does, FileError, and ConflictError where somebody else is rendering
    // another sequence into these files. A sequence's manifest is held until this object goes, so
    // that nobody replaces the frames before their movie is made.
    ExportTotals export_frames(gpu::Context& context, const ExportWatcher& watcher = {});

    // Joins the frames that were exported to each movie, in the order asked for; false if it was
    // stopped. Throws what sequence::write_movie() does.
    bool write_movies(const ExportWatcher& watcher = {}) const;

private:
    scene::Scene scene_;
    ExportOptions options_;
    SequenceName name_;
    image::Format format_;
    std::optional<ManifestWriter> manifest_;
};

} // namespace isomotion::sequence
