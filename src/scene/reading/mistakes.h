// All mistakes of a scene's document, where reading ends at the first.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/reading/document.h"

namespace isomotion::scene {

// How the document is read again. Names that a mistaken value would have used are not refused as
// unused.
enum class Rereading { all, without_unused };

struct ToldMistake {
    unsigned line = 0; // of the document, from 1 on; 0 of what --set gave
    std::string message;

    bool operator==(const ToldMistake&) const = default;
};

// Several mistakes: their messages one below the other, by line.
class Mistakes : public SceneError {
public:
    explicit Mistakes(std::vector<ToldMistake> told);
    const std::vector<ToldMistake>& told() const { return told_; }

private:
    std::vector<ToldMistake> told_;
};

// Both, what they have in common once.
Mistakes joined(const Mistakes& a, const Mistakes& b);

// All mistakes, up to twenty. `first` is what reading ended with; `read` reads the document again.
// After each mistake the value that is wrong is taken out of `root`, or a right one is put in its
// place where others are read by it, until reading succeeds, or until what it says may follow from
// what was taken out.
Mistakes all_mistakes(toml::table& root, const PlacedError& first,
                      const std::function<void(Rereading)>& read);

} // namespace isomotion::scene
