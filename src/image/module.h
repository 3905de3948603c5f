// Modules: shared libraries that are loaded when they are first needed.
#pragma once

namespace isomotion::image {

// The address of a function of the module. Throws std::runtime_error if there is none.
void* module_entry(const char* file, const char* function);

// The functions that a module's entry returns.
template<class Functions> const Functions& module_functions(const char* file, const char* entry) {
    return *reinterpret_cast<const Functions* (*)()>(module_entry(file, entry))();
}

} // namespace isomotion::image
