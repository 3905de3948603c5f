#include "isomotion/accuracy.h"

#include <algorithm>

#include <fmt/format.h>

#include "accuracy/effect_price.h"
#include "accuracy/report.h"
#include "accuracy/truth_cache.h"
#include "api/drawing/parts.h"
#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "sequence/inputs.h"
#include "shader/effect.h"

namespace isomotion {

struct Accuracy::Parts {
    accuracy::Report report;
    std::filesystem::path output;
    std::vector<Measurement> measurements;
};

namespace {

std::vector<scene::Method> methods_of(const std::vector<std::string>& names) {
    std::vector<scene::Method> methods;
    for (const std::string& name : names) {
        const auto method = scene::parse_method(name);
        if (!method) {
            throw Error(Error::Code::setting,
                        fmt::format("methods: there is no method '{}'; known: {}", name,
                                    fmt::join(isomotion::methods(), ", ")));
        }
        methods.push_back(*method);
    }
    return methods;
}

std::vector<accuracy::Setting> sweep_of(const scene::Scene& scene,
                                        const AccuracySettings& settings) {
    return accuracy::sweep(scene, methods_of(settings.methods), settings.steps);
}

accuracy::MeasureOptions options_of(const scene::Scene& scene, const AccuracySettings& settings,
                                    const Watcher& watcher) {
    if (settings.repeat < 1)
        throw Error(Error::Code::setting, "repeat: each frame is drawn at least once");
    accuracy::MeasureOptions how;
    how.frames = settings.frames;
    if (how.frames.empty()) how.frames = {scene.output.poster};
    for (const int frame : how.frames) scene::at_frame(scene, api::checked_frame(frame));
    how.width = scene.output.width;
    how.height = scene.output.height;
    how.repeat = settings.repeat;
    how.stage = render::parse_stage(settings.stage);
    if (settings.remember) how.cache = accuracy::truth_cache_folder();
    how.progress = [watcher](const std::string& what, double part) {
        if (watcher.stop && watcher.stop()) api::throw_stopped();
        if (watcher.progress) watcher.progress(what, part);
    };
    return how;
}

void expect_apart(const Scene& scene, const std::filesystem::path& output, std::size_t count) {
    if (output.empty()) return;
    const sequence::Inputs inputs(scene.files());
    for (const std::string& name : accuracy::files_written(count))
        inputs.expect_apart("output", output / name);
}

Measurement::Quantiles quantiles_of(const std::vector<float>& values) {
    return {.median = accuracy::quantile(values, 0.5),
            .p99 = accuracy::quantile(values, 0.99),
            .largest = accuracy::quantile(values, 1)};
}

Measurement measurement_of(const accuracy::Measurement& from, const scene::Isolation& own) {
    const accuracy::Errors& errors = from.errors;
    return {.name = accuracy::name(from.setting, own),
            .method = std::string(scene::name(from.setting.method)),
            .step = from.setting.step,
            .thresholds = from.setting.thresholds,
            .safety = from.setting.safety,
            .bisections = from.setting.bisections,
            .ms = from.ms,
            .spread = from.spread,
            .evaluations_a_ray = from.evaluations_a_ray(),
            .ns_an_evaluation = from.ns_an_evaluation(),
            .pixels = errors.pixels,
            .missed = errors.missed,
            .false_hits = errors.false_hits,
            .wrong_roots = errors.wrong_roots,
            .undecided = errors.undecided,
            .not_numbers = errors.nan,
            .step_limits = errors.step_limit,
            .pops = from.pops,
            .depth_error = quantiles_of(errors.depth),
            .normal_error = quantiles_of(errors.normal),
            .proved = render::proved_part(errors.proofs),
            .contradicted = errors.contradicted};
}

std::vector<Measurement> measurements_of(const accuracy::Report& report) {
    std::vector<Measurement> all;
    for (const accuracy::Measurement& each : report.measurements)
        all.push_back(measurement_of(each, report.isolation));
    for (const std::size_t k : accuracy::front(report.measurements)) all[k].is_on_front = true;
    return all;
}

const Measurement* at(const std::vector<Measurement>& all, std::optional<std::size_t> k) {
    return k ? &all[*k] : nullptr;
}

} // namespace

double Measurement::wrong_ppm() const {
    return 1e6 * double(missed + false_hits + wrong_roots) / double(pixels);
}

Accuracy::Accuracy(std::shared_ptr<const Parts> parts)
    : parts_(std::move(parts)) {}

const std::vector<Measurement>& Accuracy::measurements() const { return parts_->measurements; }

const Measurement* Accuracy::cheapest(double most_wrong_ppm) const {
    return at(parts_->measurements,
              accuracy::cheapest(parts_->report.measurements, most_wrong_ppm));
}

const Measurement* Accuracy::most_accurate(double most_ms) const {
    return at(parts_->measurements, accuracy::most_accurate(parts_->report.measurements, most_ms));
}

std::string Accuracy::summary() const {
    const accuracy::Report& report = parts_->report;
    return fmt::format("{}: {}x{}, {} frame{} from {}; {}\n{}", report.title, report.width,
                       report.height, report.frames.size(), report.frames.size() == 1 ? "" : "s",
                       report.frames.front(), report.machine, accuracy::table(report));
}

void Accuracy::write() const {
    api::with_errors([&] {
        if (parts_->output.empty())
            throw Error(Error::Code::setting, "output: no folder was named before measuring");
        accuracy::write(parts_->report, parts_->output);
    });
}

std::vector<std::string> accuracy_plan(const Scene& scene, const AccuracySettings& settings) {
    return api::with_errors([&] {
        const scene::Scene& all = scene.parts().scene;
        options_of(all, settings, {});
        std::vector<std::string> names;
        for (const accuracy::Setting& setting : sweep_of(all, settings))
            names.push_back(accuracy::name(setting, all.surfaces.front().isolation));
        expect_apart(scene, settings.output, names.size());
        return names;
    });
}

Accuracy accuracy_of(Device& device, const Scene& scene, const AccuracySettings& settings,
                     const Watcher& watcher) {
    return api::with_errors([&] {
        const scene::Scene& all = scene.parts().scene;
        const accuracy::MeasureOptions how = options_of(all, settings, watcher);
        const auto sweep = sweep_of(all, settings);
        expect_apart(scene, settings.output, sweep.size());
        gpu::Context& context = *device.parts().context;
        const shader::Stage stage = render::choose_stage(how.stage, context.info());
        auto parts = std::make_shared<Accuracy::Parts>();
        parts->output = settings.output;
        parts->report = {all.title,
                         fmt::format("{}, {}, {} shaders", context.info().renderer,
                                     context.info().version, render::name(stage)),
                         all.surfaces.front().isolation,
                         how.frames,
                         how.width,
                         how.height,
                         accuracy::measure(context, all, sweep, how)};
        parts->measurements = measurements_of(parts->report);
        return Accuracy(std::move(parts));
    });
}

std::vector<std::string> effects_of(const Scene& scene) {
    return api::with_errors([&] {
        std::vector<std::string> names;
        for (const shader::Effect effect : shader::effects(scene.parts().scene))
            names.emplace_back(shader::name(effect));
        return names;
    });
}

std::vector<EffectPrice> effect_prices(Device& device, const Scene& scene, int frame, int repeat,
                                       const std::string& stage) {
    return api::with_errors([&] {
        if (repeat < 1) throw Error(Error::Code::input, "effects are drawn at least once");
        const scene::Scene& all = scene.parts().scene;
        std::vector<EffectPrice> prices;
        for (const accuracy::EffectPrice& each : accuracy::effect_prices(
                 *device.parts().context, all, api::checked_frame(frame), all.output.width,
                 all.output.height, repeat, render::parse_stage(stage))) {
            prices.push_back(
                {std::string(shader::name(each.effect)), each.with, each.without, each.price});
        }
        return prices;
    });
}

} // namespace isomotion
