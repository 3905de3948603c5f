#include "app/choose_setting.h"

#include <algorithm>

#include "app/console.h"
#include <fmt/format.h>

#include "accuracy/measure.h"
#include "accuracy/truth_cache.h"
#include "app/progress.h"
#include "scene/surfaces.h"

namespace isomotion::app {

namespace {

using accuracy::Measurement, accuracy::Setting;

Setting own_setting(const scene::Isolation& isolation) {
    return {isolation.method, isolation.step, 1, isolation.bisections, isolation.safety};
}

// Measures one scene after the other.
class Measuring {
public:
    Measuring(gpu::Context& context, const std::vector<int>& frames, const SettingChoice& choice)
        : context_(context)
        , choice_(choice)
        , frames_{frames.front()} {
        for (const int frame : {frames[frames.size() / 2], frames.back()}) {
            if (frame != frames_.back()) frames_.push_back(frame);
        }
    }

    std::vector<Measurement> measure(const scene::Scene& scene,
                                     const std::vector<Setting>& settings) const {
        Progress progress("measuring", 1000, choice_.quiet);
        accuracy::MeasureOptions how;
        how.frames = frames_;
        how.width = side(scene, scene.output.width);
        how.height = side(scene, scene.output.height);
        how.stage = choice_.stage;
        how.cache = accuracy::truth_cache_folder();
        how.progress = [&](const std::string& what, double part) {
            progress.show(int(1000 * part), what);
        };
        return accuracy::measure(context_, scene, settings, how);
    }

    std::string told(const Measurement& of, const scene::Scene& scene) const {
        return fmt::format("{}: {:.1f} ppm wrong, {:.2f} ms a frame of {}x{}",
                           accuracy::name(of.setting, scene.surfaces.front().isolation),
                           of.errors.wrong_ppm(), of.ms, side(scene, scene.output.width),
                           side(scene, scene.output.height));
    }

private:
    static int side(const scene::Scene& scene, int pixels) {
        const double shrink =
            std::min(1.0, 256.0 / std::max(scene.output.width, scene.output.height));
        return std::max(1, int(shrink * pixels + 0.5));
    }

    gpu::Context& context_;
    const SettingChoice& choice_;
    std::vector<int> frames_;
};

// Chooses the setting for a scene with one surface, and tells what it costs.
std::optional<scene::Isolation> choose_setting(const Measuring& measuring,
                                               const scene::Scene& scene,
                                               const SettingChoice& choice, double max_wrong) {
    std::vector<scene::Method> methods;
    if (choice.keeps_method) methods.push_back(scene.surfaces.front().isolation.method);
    const auto measurements = measuring.measure(scene, accuracy::sweep(scene, methods, {}));
    const auto found = accuracy::cheapest(measurements, max_wrong);
    if (!found) return std::nullopt;
    const Measurement& best = measurements[*found];
    if (!choice.quiet) {
        const Setting usual = own_setting(scene.surfaces.front().isolation);
        const auto own = std::ranges::find_if(measurements, [&](const auto& each) {
            const Setting& s = each.setting;
            return s.method == usual.method && s.step == usual.step && s.safety == usual.safety &&
                   s.thresholds == 1 && s.bisections == usual.bisections;
        });
        print_result("{}\n", measuring.told(best, scene));
        if (own == measurements.end() || &*own == &best) {
            print_result("that is the setting without --max-wrong\n");
        } else {
            print_result("instead of {}\n", measuring.told(*own, scene));
        }
    }
    return accuracy::apply(best.setting, scene).surfaces.front().isolation;
}

} // namespace

std::optional<std::vector<scene::Isolation>> choose_settings(gpu::Context& context,
                                                             const scene::Scene& scene,
                                                             const std::vector<int>& frames,
                                                             const SettingChoice& choice) {
    const Measuring measuring(context, frames, choice);
    if (scene.surfaces.size() == 1) {
        const auto only = choose_setting(measuring, scene, choice, choice.max_wrong);
        if (!only) return std::nullopt;
        return std::vector{*only};
    }
    scene::Scene chosen = scene;
    std::vector<scene::Isolation> all;
    const std::vector<std::string> names = scene::surface_names(scene);
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (!choice.quiet) print_result("surface {}\n", names[k]);
        const auto one = choose_setting(measuring, scene::alone({scene, k}), choice,
                                        choice.max_wrong / double(names.size()));
        if (!one) return std::nullopt;
        all.push_back(*one);
        chosen.surfaces[k].isolation = *one;
    }
    const Measurement together =
        measuring.measure(chosen, {own_setting(chosen.surfaces.front().isolation)}).front();
    if (!choice.quiet) {
        print_result("together: {:.1f} ppm wrong, {:.2f} ms\n", together.errors.wrong_ppm(),
                     together.ms);
    }
    if (together.errors.wrong_ppm() > choice.max_wrong) return std::nullopt;
    return all;
}

} // namespace isomotion::app
