#include "accuracy/measure.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include <fmt/format.h>

#include "accuracy/truth_cache.h"

namespace isomotion::accuracy {
namespace {

const std::vector<shader::Channel> compared_channels{
    shader::Channel::normal, shader::Channel::position, shader::Channel::verdict};

// Hits are compared by their positions, which float can't tell apart far from the origin.
scene::SceneAt picture_of(const scene::Scene& scene, int frame) {
    return scene::in_formula_coordinates(scene::at_frame(scene, frame));
}

Measurement measure_one(gpu::Context& context, const scene::Scene& scene, const Setting& setting,
                        const std::vector<roots::Truth>& truths, const MeasureOptions& how) {
    Measurement found;
    found.setting = setting;
    const scene::Scene changed = apply(setting, scene);
    // Errors from one renderer, times from another that writes no channels.
    render::RenderOptions options{how.width, how.height, {}, {}};
    options.stage = how.stage;
    render::Renderer timed(context, changed, options);
    options.channels = compared_channels;
    if (scene.surfaces.size() > 1) options.channels.push_back(shader::Channel::surface);
    if (scene.surfaces.front().isolation.certify)
        options.channels.push_back(shader::Channel::proof);
    render::Renderer looked_at(context, changed, options);
    Popping popping;
    std::vector<double> ms;
    for (std::size_t k = 0; k < how.frames.size(); ++k) {
        const scene::SceneAt now = picture_of(changed, how.frames[k]);
        const render::Picture picture = looked_at.draw(now);
        found.evaluations += double(picture.evaluations()) / double(how.frames.size());
        const Errors errors = compare(now, picture.frame, truths[k]);
        if (k == 0) found.errors.faults = errors.faults;
        found.errors.add(errors);
        popping.add(picture.frame, truths[k]);
        if (k == 0) timed.draw(now); // drivers make their code at the first draw
        for (int again = 0; again < how.repeat; ++again) {
            render::Picture picture_again = timed.draw(now);
            ms.push_back(std::chrono::duration<double, std::milli>(picture_again.drawing).count());
            timed.reuse(std::move(picture_again));
        }
    }
    std::sort(ms.begin(), ms.end());
    found.ms = ms[ms.size() / 2];
    found.spread = (ms.back() - ms.front()) / found.ms;
    found.pops = popping.count();
    return found;
}

} // namespace

double Measurement::evaluations_a_ray() const {
    const double frames = double(errors.pixels) / double(errors.faults.size());
    return evaluations * frames / double(std::max<std::int64_t>(1, errors.rays));
}

std::vector<Measurement> measure(gpu::Context& context, const scene::Scene& scene,
                                 const std::vector<Setting>& settings, const MeasureOptions& how) {
    const auto tell = [&](const std::string& what, double part) {
        if (how.progress) how.progress(what, part);
    };
    scene::Scene sized = scene;
    sized.output.width = how.width;
    sized.output.height = how.height;
    std::vector<roots::Truth> truths;
    for (std::size_t k = 0; k < how.frames.size(); ++k) {
        const scene::SceneAt now = picture_of(sized, how.frames[k]);
        roots::Certifying certifying;
        certifying.progress = [&](double part) {
            tell(fmt::format("truth of frame {}", how.frames[k]),
                 (double(k) + part) / double(how.frames.size()));
        };
        truths.push_back(
            remembered_truth(sized, now, how.width, how.height, certifying, how.cache));
    }
    std::vector<Measurement> measurements;
    for (const Setting& setting : settings) {
        tell(name(setting, scene.surfaces.front().isolation),
             double(measurements.size()) / double(settings.size()));
        try {
            measurements.push_back(measure_one(context, sized, setting, truths, how));
        } catch (const std::length_error& error) { // other methods have shorter shaders
            if (measurements.empty() && &setting == &settings.back()) throw;
            tell(fmt::format("left out: {}", error.what()),
                 double(measurements.size()) / double(settings.size()));
        }
    }
    tell("", 1);
    return measurements;
}

std::vector<std::size_t> front(const std::vector<Measurement>& measurements) {
    std::vector<std::size_t> order(measurements.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const Measurement &x = measurements[a], &y = measurements[b];
        return std::pair(x.ms, x.errors.wrong()) < std::pair(y.ms, y.errors.wrong());
    });
    std::vector<std::size_t> best;
    for (const std::size_t k : order) {
        if (best.empty() ||
            measurements[k].errors.wrong() < measurements[best.back()].errors.wrong()) {
            best.push_back(k);
        }
    }
    return best;
}

std::optional<std::size_t> cheapest(const std::vector<Measurement>& measurements,
                                    double most_wrong_ppm) {
    for (const std::size_t k : front(measurements)) {
        if (measurements[k].errors.wrong_ppm() <= most_wrong_ppm) return k;
    }
    return std::nullopt;
}

std::optional<std::size_t> most_accurate(const std::vector<Measurement>& measurements,
                                         double most_ms) {
    std::optional<std::size_t> best;
    for (const std::size_t k : front(measurements)) {
        if (measurements[k].ms <= most_ms) best = k;
    }
    return best;
}

} // namespace isomotion::accuracy
