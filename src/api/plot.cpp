#include <cmath>

#include <fmt/format.h>

#include "api/drawing/parts.h"
#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "api/topology/parts.h"
#include "base/base64.h"
#include "image/encode.h"
#include "isomotion/page.h"
#include "topology/timeline/plot.h"
#include "topology/timeline/representative_frames.h"

namespace isomotion {
namespace {

constexpr std::size_t most_pictures = 8;
constexpr int picture_size = 192; // shown at half of it: sharp on screens of fine pixels

// What pictures show: of two surfaces that touch it is the whole scene.
Scene seen(const Topology::Parts& parts) {
    const Scene small = parts.scene.with("output.size", fmt::format("[{0},{0}]", picture_size));
    const bool is_one = parts.settings.touching.empty() && !parts.settings.surface.empty();
    return api::changed(is_one ? small.alone(parts.settings.surface) : small,
                        [](const scene::Scene& before) {
                            scene::Scene whole = before;
                            whole.sections.clear(); // the topology is that of the whole surface
                            return whole;
                        });
}

std::string drawn_at(render::Renderer& renderer, const scene::Scene& scene, double frame) {
    const double whole = std::floor(frame);
    const render::Picture picture =
        renderer.draw(scene::at_frame(scene, std::int64_t(whole), frame - whole));
    const auto png = image::encode(picture.frame, image::Format::png8);
    return "data:image/png;base64," + base::base64(png);
}

} // namespace

TopologyPlot plot_of(const Topology& topology, Device* device, const Watcher& watcher) {
    return api::with_errors([&] {
        const Topology::Parts& parts = topology.parts();
        TopologyPlot plot;
        std::vector<topology::Thumbnail> drawn;
        const auto draw = [&] {
            const Scene scene = seen(parts);
            const scene::Scene& shown = scene.parts().scene;
            render::Renderer renderer(*device->parts().context, shown,
                                      {picture_size, picture_size, {}, {}, {}});
            const auto frames = topology::representative_frames(parts.record, most_pictures);
            for (std::size_t k = 0; k < frames.size(); ++k) {
                if (watcher.progress)
                    watcher.progress("drawing", double(k) / double(frames.size()));
                if (watcher.stop && watcher.stop()) {
                    plot.undrawn = int(frames.size() - k);
                    break;
                }
                drawn.push_back({frames[k], drawn_at(renderer, shown, frames[k])});
            }
        };
        if (device) {
            try {
                draw();
            } catch (const std::exception& error) { // a shader too long, a value out of range
                plot.why_incomplete = error.what();
            }
        }
        plot.svg = topology::plot_svg(parts.record, drawn);
        return plot;
    });
}

} // namespace isomotion
