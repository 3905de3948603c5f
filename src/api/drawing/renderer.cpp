#include <algorithm>
#include <utility>

#include "api/drawing/parts.h"
#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "render/exposure.h"

namespace isomotion {

struct Renderer::Parts {
    Parts(gpu::Context& context, const Scene& drawn, render::RenderOptions options)
        : scene(drawn)
        , renderer(context, drawn.parts().scene, std::move(options)) {}

    Scene scene;
    render::Renderer renderer;
};

namespace {

render::RenderOptions options_of(const scene::Scene& scene, const RenderSettings& settings,
                                 const Watcher& watcher) {
    if (settings.width < 0 || settings.height < 0)
        throw Error(Error::Code::setting, "width, height: a picture has at least one pixel");
    render::RenderOptions options;
    options.width = settings.width > 0 ? settings.width : scene.output.width;
    options.height = settings.height > 0 ? settings.height : scene.output.height;
    if (std::max(options.width, options.height) > largest_side)
        throw Error(Error::Code::limit, "a picture has at most 16384 pixels a side");
    options.channels = api::channels_of(settings.channels);
    options.stage = render::parse_stage(settings.stage);
    options.stop = watcher.stop;
    options.warn = watcher.warn;
    if (watcher.progress)
        options.progress = [tell = watcher.progress](double part) { tell("drawing", part); };
    return options;
}

} // namespace

Renderer::Renderer(Device& device, const Scene& scene, const RenderSettings& settings,
                   Watcher watcher) {
    parts_ = api::with_errors([&] {
        return std::make_unique<Parts>(*device.parts().context, scene,
                                       options_of(scene.parts().scene, settings, watcher));
    });
}

Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Picture Renderer::draw(int frame, const std::function<void(const Picture&)>& so_far) {
    return api::with_errors([&] {
        render::Renderer& renderer = parts_->renderer;
        const render::FrameInputs inputs =
            renderer.prepare(parts_->scene.parts().scene, api::checked_frame(frame));
        if (!so_far) return api::picture_of(render::expose(renderer, inputs));
        render::Exposure exposure;
        for (const render::PictureInputs& picture : inputs.pictures) {
            exposure.add(renderer.draw(picture));
            so_far(api::picture_of(exposure.mean()));
        }
        return api::picture_of(std::move(exposure).mean());
    });
}

} // namespace isomotion
