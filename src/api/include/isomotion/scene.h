// Formulas, scenes and the first roots along the rays of a picture.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

// Names of the methods that find roots, isolation.method of a scene: "affine", "marching", ...
std::vector<std::string> methods();

// The frames of "1-10", "1-10x2", "1,3,5-9" or "9-5" (downwards), each once.
std::vector<int> frame_numbers(std::string_view text);

inline constexpr int largest_side = 16'384; // pixels of a picture

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

    struct Parts; // for isomotion itself
    const Parts& parts() const { return *parts_; }

private:
    std::shared_ptr<const Parts> parts_;
};

enum class Reach {
    own_folder, // a scene may name files of its folder and below, and isomotion's own
    anywhere,
};

class Scene {
public:
    // A scene file (.toml, Surfer's .jsurf, POV-Ray's .pov, MathMod's .js), the name of an
    // animation, or a formula. Settings are "key=value", as `--set` takes them: a parameter
    // ("r=0.5") or a key of the scene file ("camera.fov=30"); the value is a number, an expression
    // of t, or TOML. The error names all mistakes, each in a line of its own.
    static Scene load(const std::string& name, const std::vector<std::string>& settings = {},
                      Reach reach = Reach::own_folder);
    // The text of a scene file (TOML). Files that it names are looked for in `folder`.
    static Scene parse(std::string_view text, const std::vector<std::string>& settings = {},
                       const std::filesystem::path& folder = ".", Reach reach = Reach::own_folder);
    // The same scene, loaded again with one more setting; what alone() and choose_methods() made of
    // it stays.
    Scene with(const std::string& key, const std::string& value) const;
    Scene with(const std::string& key, double value) const;
    // The same scene without its other [[surfaces]].
    Scene alone(const std::string& surface) const;

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
    bool is_cut() const; // sections cut what is seen of it
    // What makes its frames take long, and what to set for less: "16 samples a pixel (--set
    // output.samples=1), 512x512 pixels (--size)".
    std::string costs() const;
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

} // namespace isomotion
