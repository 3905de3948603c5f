#include "app/frame_progress.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isomotion::app {
namespace {

constexpr std::chrono::duration<double> is_known{2}, is_long{10};
constexpr std::chrono::milliseconds shown_every{200};

} // namespace

std::string what_costs(const scene::Scene& scene) {
    std::vector<std::string> costs;
    const int samples = scene.output.samples;
    if (samples > 1)
        costs.push_back(fmt::format("{} samples a pixel (--set output.samples=1)", samples));
    int depth = 0;
    bool mirrors = false, certifies = false;
    std::size_t operations = 0;
    for (const scene::Surface& surface : scene.surfaces) {
        if (surface.material.glass) depth = std::max(depth, surface.material.glass->depth);
        mirrors |= surface.material.reflection == scene::Material::Reflection::self;
        certifies |= surface.isolation.certify;
        operations = std::max(operations, surface.field->value.instructions.size());
    }
    if (depth > 0) costs.push_back(fmt::format("glass {} rays deep (material.glass.depth)", depth));
    if (mirrors) costs.emplace_back("mirrors (material.reflection)");
    if (certifies) costs.emplace_back("proofs (--certify)");
    constexpr std::size_t is_a_lot = 2000;
    if (operations > is_a_lot)
        costs.push_back(fmt::format("a formula of {} operations", operations));
    costs.push_back(fmt::format("{}x{} pixels (--size)", scene.output.width, scene.output.height));
    return fmt::format("{}", fmt::join(costs, ", "));
}

void Pace::note(double part, Seconds passed) {
    if (part <= part_) return;
    if (compiling_ > 0) {
        --compiling_;
        begin_ = part;
        at_begin_ = passed;
    }
    part_ = part;
    at_part_ = passed;
}

std::optional<Pace::Seconds> Pace::left(Seconds passed) const {
    if (part_ <= begin_) return std::nullopt;
    const Seconds at_part = (1 - part_) / (part_ - begin_) * (at_part_ - at_begin_);
    return std::max(at_part - (passed - at_part_), Seconds(0));
}

std::optional<std::string> long_frame(int frame, Pace::Seconds passed, double part,
                                      std::optional<Pace::Seconds> left, const std::string& costs) {
    if (passed < is_known || part >= 1) return std::nullopt;
    if (!left) {
        if (passed < is_long) return std::nullopt;
        const std::string drawn = part > 0 ? fmt::format("{:.0f} %", 100 * part) : "nothing";
        return fmt::format("frame {}: {} of it is drawn after {}; what costs: {}", frame, drawn,
                           duration(passed.count()), costs);
    }
    const Pace::Seconds all = passed + *left;
    if (all < is_long) return std::nullopt;
    return fmt::format("frame {} takes some {}: {:.0f} % are drawn after {}; what costs: {}", frame,
                       duration(all.count()), 100 * part, duration(passed.count()), costs);
}

void FrameProgress::show(const sequence::ExportProgress& now) {
    const auto time = Clock::now();
    const std::string name = now.file.filename().string();
    if (now.done != done_) {
        done_ = now.done;
        begin_ = shown_ = time;
        pace_ = {};
        progress_.show(done_, name);
        return;
    }
    const Pace::Seconds passed = time - begin_;
    pace_.note(now.part, passed);
    const std::optional<Pace::Seconds> left = pace_.left(passed);
    if (!told_) {
        if (const auto text = long_frame(now.frame, passed, now.part, left, costs_)) {
            progress_.tell(*text);
            told_ = true;
        }
    }
    if (time - shown_ < shown_every) return;
    shown_ = time;
    progress_.show(done_ + now.part,
                   fmt::format("{}, {:.0f} % of it{}", name, 100 * now.part,
                               left ? ", " + duration(left->count()) + " left" : ""));
}

} // namespace isomotion::app
