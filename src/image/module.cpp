#include "image/module.h"

#include <string>

#include <dlfcn.h>
#include <fmt/format.h>
#include <isomotion/error.h>

#include "base/loading.h"

namespace isomotion::image {

// The entry has the version in its name: a program built against other headers finds none.
//
// The loader finds the module by the run path of the program, which CMake gives to those that link
// this library. It is never closed: what it throws and the threads of its libraries live on.
void* module_entry(const char* file, const char* function) {
    void* const library = ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
    void* const entry = library ? ::dlsym(library, function) : nullptr;
    if (!entry) {
        const std::string words = ::dlerror();
        const bool is_missing =
            words.starts_with(file) && words.find("cannot open shared object file") != words.npos;
        throw Error(Error::Code::file,
                    fmt::format("pictures cannot be read or written: {}{}",
                                base::why_not_loaded(words),
                                is_missing ? "; it comes with isomotion, in lib/isomotion" : ""));
    }
    return entry;
}

} // namespace isomotion::image
