// isomotion as a library: implicit surfaces F(x, y, z; parameters) = 0 that move are drawn, proved
// and exported. This header and its part error.h are all there is; no other library's types are in
// them.
//
//     const auto scene = isomotion::Scene::load("blobby75", {"output.size=[640, 480]"});
//     isomotion::Device device;
//     isomotion::Renderer(device, scene).draw(scene.poster()).write("blobby75.png");
//
// Lengths are in scene units, times in seconds, frames count from 1. Coordinates of formulas,
// roots and events are those of the formula; those of a placed surface differ from the world's.
//
// Functions throw Error, or std::bad_alloc. Objects but Device and Renderer are values that never
// change: copies are cheap, and all threads may use them. A Device and its Renderers belong to the
// thread that made the Device. Several threads may have one each if all are of one kind and the
// first was made before the other threads began. Callbacks must not throw. Proofs and bounds hold
// while processors round to nearest, as they do unless a program changes it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <isomotion/error.h>

namespace isomotion {

// Names the folder that holds shaders/ and animations/. Programs that find isomotion by CMake need
// not: this header does it for them. $ISOMOTION_DATA goes before it.
void set_data_folder(const std::filesystem::path& folder);
#ifdef ISOMOTION_DATA_FOLDER
inline const bool data_folder_is_set = (set_data_folder(ISOMOTION_DATA_FOLDER), true);
#endif

// Names of the animations that come with isomotion, sorted. Scene::load takes them.
std::vector<std::string> animations();

using Point = std::array<double, 3>;

// A closed interval of real numbers; infinite where there is no bound.
struct Interval {
    double low = 0, high = 0;
    bool operator==(const Interval&) const = default;
};
using Box = std::array<Interval, 3>;

// F(x, y, z; parameters), apart from any scene.
class Formula {
public:
    // "x^2 + y^2 + z^2 = r^2", or one side of it. Every name but x, y, z and pi must be among the
    // parameters.
    explicit Formula(std::string_view text, std::map<std::string, double> parameters = {});
    // The same formula with another value of a parameter.
    Formula with(const std::string& parameter, double value) const;
    const std::map<std::string, double>& parameters() const; // finite numbers

    double value(const Point& at) const;
    Point gradient(const Point& at) const;
    std::vector<double> values(std::span<const Point> at) const; // faster than one by one
    // Holds F at every point of the box, whatever is rounded; everything where F has no value
    // somewhere.
    Interval bound(const Box& box) const;

    // There is no move, which would leave nothing behind.
    Formula(const Formula&) = default;
    Formula& operator=(const Formula&) = default;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

enum class Reach {
    own_folder, // a scene may name files of its folder and below, and isomotion's own
    anywhere,
};

class Scene {
public:
    // A scene file (.toml, Surfer's .jsurf, POV-Ray's .pov), the name of an animation, or a
    // formula. Settings are "key=value", as `--set` takes them: a parameter ("r=0.5") or a key of
    // the scene file ("camera.fov=30"); the value is a number, an expression of t, or TOML. The
    // error names all mistakes, each in a line of its own.
    static Scene load(const std::string& name, const std::vector<std::string>& settings = {},
                      Reach reach = Reach::own_folder);
    // The text of a scene file (TOML). Files that it names are looked for in `folder`.
    static Scene parse(std::string_view text, const std::vector<std::string>& settings = {},
                       const std::filesystem::path& folder = ".", Reach reach = Reach::own_folder);
    // The same scene, loaded again with one more setting.
    Scene with(const std::string& key, const std::string& value) const;
    Scene with(const std::string& key, double value) const;

    const std::string& title() const;
    // A name for files: that of the scene's own without its extension, "formula" or "scene".
    std::string name() const;
    // Its own file; none for a formula or a text.
    std::optional<std::filesystem::path> file() const;
    // All files that the scene was read from, each once.
    std::vector<std::filesystem::path> files() const;
    int frames() const;
    double frames_per_second() const;
    double time(int frame) const;
    int poster() const; // the frame that represents the animation
    int width() const;  // pixels of its pictures
    int height() const;
    // The names of [[surfaces]], in the file's order; one empty name without such a list.
    std::vector<std::string> surfaces() const;
    // The parameters of a surface with their values at a frame.
    std::map<std::string, double> parameters(int frame, const std::string& surface = {}) const;

    Scene(const Scene&) = default;
    Scene& operator=(const Scene&) = default;

    struct Parts; // for isomotion itself
    explicit Scene(std::shared_ptr<const Parts> parts);
    const Parts& parts() const { return *parts_; }

private:
    std::shared_ptr<const Parts> parts_;
};

// What is certain of a pixel's ray, by interval arithmetic.
struct FirstRoot {
    enum class Answer {
        miss,     // no root
        hit,      // the first root is simple and lies in `root`
        touching, // there may be roots in `touch`; then `root`, if `hit_behind`, or none
        undecided // no root before root.low
    };
    Answer answer = Answer::miss;
    Interval root, touch; // t on the ray, in the first surface's coordinates
    bool hit_behind = false;
    int surface = 0; // which is hit; -1: none, or it is unknown
};

struct Watcher {
    // Returns true to stop. It is called often, and from one thread at a time.
    std::function<bool()> stop = {};
    std::function<void(const std::string& what, double part)> progress = {}; // part: 0 to 1
    std::function<void(const std::string&)> warn = {};
};

// The first roots along the rays through the centres of all pixels, rows from the top.
std::vector<FirstRoot> first_roots(const Scene& scene, int frame, int width, int height,
                                   const Watcher& watcher = {});

// Betti numbers of a solid.
struct Betti {
    int components = 0, tunnels = 0, voids = 0;
    bool operator==(const Betti&) const = default;
};

struct TopologyEvent {
    std::string kind; // "merge", "split", "tunnel forms", ...; "unknown"
    Interval time;    // seconds; holds the exact time
    Box where;        // holds the exact place
    bool proved = false;
    std::optional<Betti> before, after; // of the solid, where they are known
};

struct Topology {
    std::vector<TopologyEvent> events; // by time
    std::optional<Betti> start, end;
    bool complete = false;           // nothing is missing, and all of it is proved
    std::vector<std::string> doubts; // why it is not complete
    std::string summary;             // some lines for people
    std::string json;                // a timeline file, as `isomotion topology -o` writes it
};

struct TopologySettings {
    enum class Certify { off, fast, full };
    Certify certify = Certify::full;
    // 0: the scene's last frame. Later ones may be searched, too: motions go on.
    int first = 1, last = 0;
    std::string surface = {};                   // of [[surfaces]]
    std::string touching = {};                  // another one: what both have in common
    std::optional<bool> solid_is_negative = {}; // unset: the side that the bounds don't touch
    int threads = 0;                            // 0: as many as the machine runs at once
};

// When parts of the surface merge, split, open and close. A stopped search gives what is known so
// far, with its doubts.
Topology topology_of(const Scene& scene, const TopologySettings& settings = {},
                     const Watcher& watcher = {});

// An OpenGL context, without a window that is seen. One that was moved from can only be assigned
// to.
class Device {
public:
    enum class Kind { automatic, egl, osmesa, window };
    explicit Device(Kind kind = Kind::automatic);
    Device(Device&&) noexcept;
    Device& operator=(Device&&) noexcept;
    ~Device();
    std::string name() const; // of the renderer, its driver and how it was opened

    struct Parts; // for isomotion itself
    explicit Device(std::unique_ptr<Parts> parts);
    Parts& parts() const { return *parts_; }

private:
    std::unique_ptr<Parts> parts_;
};

// A drawn frame.
struct Picture {
    // A number for each pixel, row by row from the top.
    struct Plane {
        std::string name; // R G B: linear light times A; A; and those of the channels asked for
        std::vector<float> values;
    };
    int width = 0, height = 0;
    std::vector<Plane> planes;
    // Rays by how they ended, over all samples.
    std::int64_t misses = 0, hits = 0, step_limits = 0, not_numbers = 0, zero_gradients = 0;
    std::int64_t evaluations = 0; // of the field
    double seconds = 0;           // of drawing

    // Null if there is no such plane.
    const Plane* find(std::string_view name) const;
    // sRGB, 8 bits, not premultiplied: R G B A for each pixel, row by row from the top.
    std::vector<std::uint8_t> rgba8() const;
    // A hash of the samples of all planes.
    std::string fingerprint() const;
    // A .png of the colours, or an .exr of all planes. The file appears when it is whole.
    void write(const std::filesystem::path& file) const;
};

struct RenderSettings {
    int width = 0, height = 0;              // 0: the scene's
    std::vector<std::string> channels = {}; // "z", "n", "verdict", ...: docs/rendering.md
};

// Draws frames of one scene, whose shaders are compiled once. Frames beyond the scene's last are
// there, too. One that was moved from can only be assigned to.
class Renderer {
public:
    // The device must outlive it.
    Renderer(Device& device, const Scene& scene, const RenderSettings& settings = {},
             Watcher watcher = {});
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();
    Picture draw(int frame);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// Joins pictures of one size to a .mp4, .webm or .gif by the ffmpeg on PATH, at the scene's rate.
// `picture` is asked for 0 to count - 1, in order. Returns false if it was stopped; then a file of
// that name is as it was.
bool write_movie(const std::filesystem::path& file, const Scene& scene, int count,
                 const std::function<Picture(int)>& picture, const Watcher& watcher = {});

struct ExportSettings {
    std::string output;  // "out/name.####.png" or .exr
    std::string frames;  // "1-10", "1-100x2", "1,3,5-9"; empty: all
    bool resume = false; // keep files that are already what these settings draw
    std::vector<std::filesystem::path> movies = {}; // .mp4, .webm or .gif of the frames
    std::vector<std::string> channels = {};         // of an EXR, besides the colours
    int bits = 8;                                   // of a PNG: 8 or 16
    std::optional<int> audit = {}; // rays of each frame compared with truth; unset: some; 0: none
};

struct Exported {
    int drawn = 0, reused = 0, kept = 0;           // frames; reused ones equal the one before
    std::int64_t hits = 0, wrong = 0, audited = 0; // rays
    bool stopped = false;                          // the files already written are whole
};

// Writes frames and a manifest that describes them, from which they can be resumed and verified.
// The progress is told for each frame: its file, and the part of all frames that is done.
Exported export_frames(Device& device, const Scene& scene, const ExportSettings& settings,
                       const Watcher& watcher = {});

struct Verified {
    bool whole = false; // every frame that was asked for is as it was written
    std::vector<int> missing, changed;
};

// Compares files with their manifest, "out/name.manifest"; `pixels`: decodes each picture, too.
Verified verify(const std::filesystem::path& manifest, bool pixels = false);

struct PageSettings {
    // A report of `isomotion accuracy`, whose wrong pixels and times the page shows.
    std::optional<std::filesystem::path> report = {};
    std::vector<std::byte> movie = {}; // an MP4, for browsers that cannot draw the scene
};

// A scene as one HTML file, which plays it in a browser.
std::string page_of(const Scene& scene, const PageSettings& settings = {},
                    const std::function<void(const std::string&)>& warn = {});

} // namespace isomotion
