#include "accuracy/effect_price.h"

#include <algorithm>

#include "render/exposure.h"

namespace isomotion::accuracy {
namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

std::vector<EffectPrice> effect_prices(gpu::Context& context, const scene::Scene& scene, int frame,
                                       int width, int height, int pairs,
                                       render::StageChoice stage) {
    const auto ms = [&](render::Renderer& renderer, const scene::Scene& drawn) {
        const render::Picture picture = render::expose(renderer, drawn, frame);
        return std::chrono::duration<double, std::milli>(picture.drawing).count();
    };
    render::RenderOptions options{width, height, {}, {}};
    options.stage = stage;
    render::Renderer full(context, scene, options);
    ms(full, scene); // drivers make their code at the first draw
    std::vector<EffectPrice> prices;
    for (const shader::Effect effect : shader::effects(scene)) {
        const scene::Scene less = shader::without(effect, scene);
        render::Renderer partial(context, less, options);
        ms(partial, less);
        std::vector<double> with, without, difference;
        for (int k = 0; k < pairs; ++k) {
            with.push_back(ms(full, scene));
            without.push_back(ms(partial, less));
            difference.push_back(with.back() - without.back());
        }
        prices.push_back({effect, median(with), median(without), median(difference)});
    }
    return prices;
}

} // namespace isomotion::accuracy
