// Keys of scene files that were renamed. Files with the old name still load, and mean the same.
#pragma once

#include <string>
#include <string_view>

namespace isomotion::scene {

struct RenamedKey {
    std::string_view section; // "arrays.*" stands for every array
    std::string_view now, before;
};

// The key of `section` that is, or was, called `name`; null where no such key was renamed.
const RenamedKey* renamed_key(std::string_view section, std::string_view name);

// A track's name in which each key has its first name: "surface.placement.scale".
std::string first_name(std::string_view track);

} // namespace isomotion::scene
