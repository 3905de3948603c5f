#include "app/open_context.h"

#include "api/drawing/parts.h"
#include "app/commands.h"
#include "base/last_words.h"

namespace isomotion::app {

void check_backend(const std::string& backend) { gpu::parse_backend(backend); }

Device open_device(const std::string& backend) {
    const gpu::Backend parsed = gpu::parse_backend(backend);
    auto words = words_on_crash();
    auto context = gpu::Context::create(parsed);
    context->keep_until_drawn(std::move(words));
    return Device(std::make_unique<Device::Parts>(Device::Parts{std::move(context)}));
}

std::shared_ptr<void> words_on_crash() {
    return std::make_shared<base::LastWords>(
        "the program crashed before the first picture was drawn, most likely in the OpenGL driver. "
        "isomotion doctor tells which back ends work (--backend egl, osmesa). Variables such as "
        "GALLIUM_DRIVER and LP_NATIVE_VECTOR_WIDTH in the environment, and too little memory "
        "(ulimit -v), make drivers crash. If there is no such thing here, please report this\n",
        exit_machine);
}

} // namespace isomotion::app
