// The reason why a library could not be loaded.
#pragma once

#include <string>

namespace isomotion::base {

// The loader's message, preceded by its meaning if it only mentions memory.
inline std::string why_not_loaded(const std::string& words) {
    for (const char* sign : {"failed to map segment", "annot allocate", "annot create shared"}) {
        if (words.find(sign) != words.npos)
            return "out of memory, or a disk mounted noexec: " + words;
    }
    return words;
}

} // namespace isomotion::base
