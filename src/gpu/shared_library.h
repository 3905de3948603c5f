#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <stdexcept>
#include <string>

#include "base/loading.h"

namespace isomotion::gpu {

/// A library loaded at run time, so that the program starts without an installed driver.
///
/// It stays open to the end of the process, since drivers leave handlers that run at exit.
class SharedLibrary {
public:
    /// Opens the first of `names` that can be opened; throws with the loader's reasons if none can.
    explicit SharedLibrary(std::initializer_list<const char*> names) {
        std::string reasons;
        for (const char* name : names) {
            // Local: a driver's gl* must not become visible to other libraries.
            handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
            if (handle_) return;
            reasons += (reasons.empty() ? "" : "; ");
            reasons += base::why_not_loaded(dlerror());
        }
        throw std::runtime_error(reasons);
    }

    template<typename Function> Function* find(const char* symbol) const {
        void* address = dlsym(handle_, symbol);
        if (!address) throw std::runtime_error(std::string(symbol) + " is missing in the library");
        return reinterpret_cast<Function*>(address);
    }

private:
    void* handle_ = nullptr;
};

} // namespace isomotion::gpu
