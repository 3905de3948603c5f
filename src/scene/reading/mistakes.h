// Collects all mistakes of a scene's document, although reading stops at the first.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/reading/document.h"

namespace isomotion::scene {

// How the document is read again. With `without_unused`, names that a mistaken value may have used
// are not reported as unused.
enum class Rereading { all, without_unused };

struct ToldMistake {
    unsigned line = 0; // of the document, counted from 1; 0 for mistakes of --set
    std::string message;

    bool operator==(const ToldMistake&) const = default;
};

// Several mistakes. The message has one per line, ordered by line of the document.
class Mistakes : public SceneError {
public:
    explicit Mistakes(std::vector<ToldMistake> told);
    const std::vector<ToldMistake>& told() const { return told_; }

private:
    std::vector<ToldMistake> told_;
};

// Both lists, with common entries once.
Mistakes joined(const Mistakes& a, const Mistakes& b);

// All mistakes, up to twenty. `first` is the mistake at which reading stopped; `read` reads the
// document again. After each mistake the wrong value is removed from `root`, or replaced by a valid
// one if other values depend on it. This goes on until reading succeeds, or until a mistake may be
// a consequence of a removal.
Mistakes all_mistakes(toml::table& root, const PlacedError& first,
                      const std::function<void(Rereading)>& read);

} // namespace isomotion::scene
