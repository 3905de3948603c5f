// A scene file of the tests: a scene, and from its first line [expect] on what must be true of its
// pictures. tests/README.md describes the keys.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/document.h"
#include "scenes/drawn.h"

namespace isomotion::scenes {

// Pixels, and what is true of them or of the whole pictures.
struct That {
    std::string let;                // "name = formula;" for all statements of pixels
    std::vector<std::string> where; // all pixels, or those of which all of this is true
    std::vector<std::string> is;    // of each of them
    double within = 0;
    std::int64_t least = 1, most = 1'000'000'000; // pixels that there are
    std::int64_t but = 0;                         // pixels of which it may be false
    std::map<std::string, std::string> sums;      // over these pixels, which `counts` may name
    std::vector<std::string> counts;              // of whole pictures
};

// A picture that all layers are as those of. Where they are to be the same bits, so are all counts.
struct Same {
    std::string as, of;               // names of pictures; empty: the scene as it is
    std::vector<std::string> without; // layers as files call them: "evaluations", "N.X"
    double within = 0;
    std::int64_t but = 0; // pixels of each layer
};

// Faults against certified truth of a picture.
struct Truth {
    std::string of; // the picture's name; empty: the scene as it is
    std::int64_t wrong = 0, undecided = 0;
};

// A scene among the hard cases (hard_case.h).
struct Methods {
    std::string label;
    std::map<std::string, double> wrong_ppm; // by method, and `default`
    Values truth_of;                         // values of places, for a formula easier to certify
    bool any_size = true;
};

struct Expectations {
    std::map<std::string, Look> pictures; // by name; "" is the scene as it is
    std::vector<That> that;
    std::vector<Same> same;
    std::vector<Truth> truths;
    std::optional<Methods> methods;
    std::vector<std::string> refused; // words of the message with which drawing fails
};

class SceneFile {
public:
    // Throws base::InputError with the line of a mistake.
    explicit SceneFile(const std::filesystem::path& file);

    const std::string& path() const { return path_; }
    const std::string& scene() const { return scene_; }
    bool is_for_every_backend() const { return every_backend_; }
    std::vector<std::string> tests() const; // their names

    // What a test expects, once for each combination of what it tries, by the values' words.
    std::vector<std::pair<std::string, Expectations>> expected_of(const std::string& test) const;

private:
    Expectations expected(const std::string& test, const Values& values) const;

    std::string path_, scene_, tail_;
    bool every_backend_ = false;
    Values with_; // of every test
    std::vector<std::pair<std::string, Values>> tests_;
    // Every combination of `each_`, with every one of `try_` if the test is thorough (thorough.h),
    // and else with as few as have each value once.
    std::vector<std::pair<std::string, std::vector<std::string>>> each_, try_;
};

} // namespace isomotion::scenes
