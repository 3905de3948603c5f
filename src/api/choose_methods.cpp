#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "accuracy/measure.h"
#include "accuracy/truth_cache.h"
#include "api/drawing/parts.h"
#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "isomotion/accuracy.h"
#include "scene/surfaces.h"

namespace isomotion {
namespace {

accuracy::Setting own_setting(const scene::Isolation& isolation) {
    return {isolation.method, isolation.step, 1, isolation.bisections, isolation.safety};
}

// The first, the middle and the last one.
std::vector<int> some_of(const std::vector<int>& frames) {
    std::vector<int> some{frames.front()};
    for (const int frame : {frames[frames.size() / 2], frames.back()}) {
        if (frame != some.back()) some.push_back(frame);
    }
    return some;
}

// Chooses methods and tells what they cost.
class Choosing {
public:
    Choosing(gpu::Context& context, const ChoiceSettings& settings, const Watcher& watcher)
        : context_(context)
        , settings_(settings) {
        how_.stage = render::parse_stage(settings.stage);
        if (settings.remember) how_.cache = accuracy::truth_cache_folder();
        how_.progress = [watcher](const std::string& what, double part) {
            if (watcher.stop && watcher.stop()) api::throw_stopped();
            if (watcher.progress) watcher.progress(what, part);
        };
    }

    // One for each surface; none if no setting is accurate enough.
    std::optional<std::vector<scene::Isolation>> choose(const scene::Scene& scene) {
        how_.frames =
            some_of(settings_.frames.empty() ? std::vector{scene.output.poster} : settings_.frames);
        for (const int frame : how_.frames) api::checked_frame(frame);
        if (scene.surfaces.size() == 1) {
            const auto only = of_surface(scene, settings_.most_wrong_ppm);
            if (!only) return std::nullopt;
            return std::vector{*only};
        }
        scene::Scene chosen = scene;
        std::vector<scene::Isolation> all;
        const std::vector<std::string> names = scene::surface_names(scene);
        for (std::size_t k = 0; k < names.size(); ++k) {
            told_ += fmt::format("surface {}\n", names[k]);
            const auto one = of_surface(scene::alone({scene, k}),
                                        settings_.most_wrong_ppm / double(names.size()));
            if (!one) return std::nullopt;
            all.push_back(*one);
            chosen.surfaces[k].isolation = *one;
        }
        const accuracy::Measurement together =
            measure(chosen, {own_setting(chosen.surfaces.front().isolation)}).front();
        told_ += fmt::format("together: {:.1f} ppm wrong, {:.2f} ms\n", together.errors.wrong_ppm(),
                             together.ms);
        if (together.errors.wrong_ppm() > settings_.most_wrong_ppm) return std::nullopt;
        return all;
    }

    const std::string& told() const { return told_; }

private:
    std::optional<scene::Isolation> of_surface(const scene::Scene& scene, double most_wrong) {
        std::vector<scene::Method> methods;
        if (settings_.keep_method) methods.push_back(scene.surfaces.front().isolation.method);
        const auto measurements = measure(scene, accuracy::sweep(scene, methods, {}));
        const auto found = accuracy::cheapest(measurements, most_wrong);
        if (!found) return std::nullopt;
        const accuracy::Measurement& best = measurements[*found];
        const accuracy::Setting usual = own_setting(scene.surfaces.front().isolation);
        const auto own = std::ranges::find_if(measurements, [&](const auto& each) {
            const accuracy::Setting& s = each.setting;
            return s.method == usual.method && s.step == usual.step && s.safety == usual.safety &&
                   s.thresholds == 1 && s.bisections == usual.bisections;
        });
        told_ += words(best, scene) + "\n";
        if (own == measurements.end() || &*own == &best) {
            told_ += "that is the setting without --max-wrong\n";
        } else {
            told_ += "instead of " + words(*own, scene) + "\n";
        }
        return accuracy::apply(best.setting, scene).surfaces.front().isolation;
    }

    std::vector<accuracy::Measurement> measure(const scene::Scene& scene,
                                               const std::vector<accuracy::Setting>& settings) {
        how_.width = side(scene, scene.output.width);
        how_.height = side(scene, scene.output.height);
        return accuracy::measure(context_, scene, settings, how_);
    }

    static std::string words(const accuracy::Measurement& of, const scene::Scene& scene) {
        return fmt::format("{}: {:.1f} ppm wrong, {:.2f} ms a frame of {}x{}",
                           accuracy::name(of.setting, scene.surfaces.front().isolation),
                           of.errors.wrong_ppm(), of.ms, side(scene, scene.output.width),
                           side(scene, scene.output.height));
    }

    static int side(const scene::Scene& scene, int pixels) {
        const double shrink =
            std::min(1.0, 256.0 / std::max(scene.output.width, scene.output.height));
        return std::max(1, int(shrink * pixels + 0.5));
    }

    gpu::Context& context_;
    const ChoiceSettings& settings_;
    accuracy::MeasureOptions how_;
    std::string told_;
};

} // namespace

Choice choose_methods(Device& device, const Scene& scene, const ChoiceSettings& settings,
                      const Watcher& watcher) {
    return api::with_errors([&] {
        Choosing choosing(*device.parts().context, settings, watcher);
        const auto chosen = choosing.choose(scene.parts().scene);
        Choice choice{.scene = {}, .summary = choosing.told()};
        if (!chosen) return choice;
        choice.scene = api::changed(scene, [all = *chosen](const scene::Scene& before) {
            scene::Scene with = before;
            for (std::size_t k = 0; k < std::min(all.size(), with.surfaces.size()); ++k) {
                scene::Isolation& isolation = with.surfaces[k].isolation;
                const bool certify = isolation.certify;
                isolation = all[k];
                isolation.certify = certify;
            }
            return with;
        });
        return choice;
    });
}

} // namespace isomotion
