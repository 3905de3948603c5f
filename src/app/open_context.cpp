#include "app/open_context.h"

#include "app/commands.h"
#include "base/last_words.h"

namespace isomotion::app {

std::unique_ptr<gpu::Context> open_context(const std::string& backend) {
    const gpu::Backend parsed = gpu::parse_backend(backend);
    const base::LastWords words(
        "the OpenGL driver crashed while it was loaded; isomotion doctor tells which back ends "
        "work (--backend egl, osmesa). Variables such as GALLIUM_DRIVER and LP_NATIVE_VECTOR_WIDTH "
        "in the environment, and too little memory (ulimit -v), make drivers crash\n",
        exit_machine);
    return gpu::Context::create(parsed);
}

} // namespace isomotion::app
