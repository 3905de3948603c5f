// All mistakes of a scene's document, where reading ends at the first.
#pragma once

#include <functional>
#include <string>

#include "scene/reading/document.h"

namespace isomotion::scene {

// How the document is read again. Names that a mistaken value would have used are not refused as
// unused.
enum class Rereading { all, without_unused };

// The messages of all mistakes, one below the other, by line. `first` is what reading ended with;
// `read` reads the document again. After each mistake the value that is wrong is taken out of
// `root`, until reading succeeds, or until what it says may follow from what was taken out.
std::string all_mistakes(toml::table& root, const PlacedError& first,
                         const std::function<void(Rereading)>& read);

} // namespace isomotion::scene
