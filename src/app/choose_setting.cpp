#include "app/choose_setting.h"

#include <algorithm>

#include "app/console.h"
#include <fmt/format.h>

#include "accuracy/measure.h"
#include "accuracy/truth_cache.h"
#include "app/progress.h"

namespace isomotion::app {

std::optional<scene::Isolation> choose_setting(gpu::Context& context, const scene::Scene& scene,
                                               const std::vector<int>& frames,
                                               const SettingChoice& choice) {
    accuracy::MeasureOptions measuring;
    measuring.frames = {frames.front()};
    for (const int frame : {frames[frames.size() / 2], frames.back()}) {
        if (frame != measuring.frames.back()) measuring.frames.push_back(frame);
    }
    const double shrink = std::min(1.0, 256.0 / std::max(scene.output.width, scene.output.height));
    measuring.width = std::max(1, int(shrink * scene.output.width + 0.5));
    measuring.height = std::max(1, int(shrink * scene.output.height + 0.5));
    measuring.stage = choice.stage;
    measuring.cache = accuracy::truth_cache_folder();
    std::vector<scene::Method> methods;
    if (choice.keeps_method) methods.push_back(scene.isolation.method);
    Progress progress("measuring", 1000, choice.quiet);
    measuring.progress = [&](const std::string& what, double part) {
        progress.show(int(1000 * part), what);
    };
    const auto measurements =
        accuracy::measure(context, scene, accuracy::sweep(scene, methods, {}), measuring);
    const auto found = accuracy::cheapest(measurements, choice.max_wrong);
    if (!found) return std::nullopt;
    const accuracy::Measurement& best = measurements[*found];
    if (!choice.quiet) {
        const auto told = [&](const accuracy::Measurement& of) {
            return fmt::format("{}: {:.1f} ppm wrong, {:.2f} ms a frame of {}x{}",
                               accuracy::name(of.setting, scene.isolation), of.errors.wrong_ppm(),
                               of.ms, measuring.width, measuring.height);
        };
        const auto own = std::ranges::find_if(measurements, [&](const auto& each) {
            const accuracy::Setting& s = each.setting;
            return s.method == scene.isolation.method && s.step == scene.isolation.step &&
                   s.safety == scene.isolation.safety && s.thresholds == 1 &&
                   s.bisections == scene.isolation.bisections;
        });
        print_result("{}\n", told(best));
        if (own == measurements.end() || &*own == &best) {
            print_result("that is the setting without --max-wrong\n");
        } else {
            print_result("instead of {}\n", told(*own));
        }
    }
    return accuracy::apply(best.setting, scene).isolation;
}

} // namespace isomotion::app
