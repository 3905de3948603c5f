// Frames as files, and movies of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <isomotion/drawing.h>

namespace isomotion {

// Joins pictures of one size to a .mp4, .webm or .gif by the ffmpeg on PATH, at the scene's rate.
// `picture` is asked for 0 to count - 1, in order. Returns false if it was stopped; then a file of
// that name is as it was.
bool write_movie(const std::filesystem::path& file, const Scene& scene, int count,
                 const std::function<Picture(int)>& picture, const Watcher& watcher = {});

struct ExportSettings {
    std::string output = {}; // "out/name.####.png" or .exr; empty: out/, the scene's name and .png
    std::vector<int> frames = {};  // empty: all
    std::vector<int> part_of = {}; // frames of the sequence that these are a part of; empty: these
    bool resume = false;           // keep files that are already what these settings draw
    std::vector<std::filesystem::path> movies = {}; // .mp4, .webm or .gif of the frames
    std::vector<std::string> channels = {};         // of an EXR, besides the colours
    int bits = 8;                                   // of a PNG: 8 or 16
    std::string stage = "fragment";                 // as of a Renderer
    // Rays of each frame that are compared with truth; unset: as many as are cheap; 0: none.
    std::optional<int> audit = {};
};
inline constexpr int most_audited = 1'000'000;

struct ExportProgress {
    int count = 0; // of all frames
    int done = 0;  // before this one
    int frame = 0;
    std::filesystem::path file = {};
    double part = 0;                 // of the frame, 0 to 1
    double seconds = 0;              // since it was begun
    std::optional<double> left = {}; // seconds until it is drawn, once that can be told
    // A frame before this one that takes longer than was reckoned with; `seconds` are of that.
    std::optional<int> landing = {};
};

// As a Watcher.
struct ExportWatcher {
    std::function<bool()> stop = {};
    std::function<void(const ExportProgress&)> progress = {};
    std::function<void(const std::string&)> warn = {};
};

// What became of the frames, and the rays of those that were drawn.
struct Exported : RayStatistics {
    int drawn = 0, reused = 0, kept = 0; // frames; reused ones equal the one before
    struct Again {
        std::string why; // "missing", "truncated or changed", "of other settings", ...
        std::vector<int> frames;
    };
    std::vector<Again> not_kept = {}; // with `resume`
    // Rays compared with truth: those of which it is certain, of these the wrong ones; and others.
    std::int64_t audited = 0, wrong = 0, undecided = 0;
    std::int64_t without_colour = 0; // pixels whose colour is infinite or no number
    bool stopped = false;            // the files already written are whole

    // Some lines for people. `all_seconds`: how long all of it took, drawing and the rest.
    std::string summary(double all_seconds) const;
};

// Writes frames and a manifest that describes them, from which they can be resumed and verified.
class Exporter {
public:
    // Throws for all that can be foreseen to fail before there is a Device: contradicting settings,
    // an output that would replace a file which the scene is read from, a value that leaves its
    // range at some frame. `warn` is told of frames beyond the scene's, which bounds may cut.
    Exporter(const Scene& scene, const ExportSettings& settings,
             const std::function<void(const std::string&)>& warn = {});
    Exporter(Exporter&&) noexcept;
    Exporter& operator=(Exporter&&) noexcept;
    ~Exporter();

    const std::vector<int>& frames() const; // in the order that was asked for
    const std::string& output() const;
    // A line for people: what is drawn, in which size, by which method and what.
    std::string plan(const Device& device) const;
    // Makes the folders of all files, and looks for ffmpeg if there is a movie. write_frames()
    // does it, too.
    void prepare() const;

    // Warns of likely mistakes of the scene, of undecided and wrong rays, and of nothing being hit.
    // Until this object is gone, no other process can write frames of other settings there.
    Exported write_frames(Device& device, const ExportWatcher& watcher = {});
    // Joins the frames' files to each movie. Returns false if it was stopped.
    bool write_movies(const std::function<bool()>& stop = {}) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// All of it: the frames, and the movies of them.
Exported export_frames(Device& device, const Scene& scene, const ExportSettings& settings,
                       const ExportWatcher& watcher = {});

struct Verified {
    bool whole = false; // every frame that was asked for is as it was written
    std::vector<int> missing, changed;
};

// Compares files with their manifest, "out/name.manifest"; `pixels`: decodes each picture, too.
Verified verify(const std::filesystem::path& manifest, bool pixels = false);

} // namespace isomotion
