#include "audit/audit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <set>

#include <fmt/format.h>

#include "roots/cut_rays.h"
#include "roots/nearest.h"
#include "roots/tube.h"

namespace isomotion::audit {
namespace {

constexpr std::size_t most_examples = 8;
constexpr double fewest_rays = 64, most_rays = 16'384;
constexpr double cheap_operations = 2e6; // at a point, of all rays of a frame
constexpr int usual_list = 256; // elements that matter at a place, where there are very many
constexpr double part_of_drawing = 0.03;
constexpr std::size_t rays_together = 64;
// A ray that takes more is left undecided: an audit is to be cheap, and there are other rays.
constexpr roots::Budget budget{.evaluations = 2'000};

// 30720 as "30,720".
std::string with_commas(std::int64_t number) {
    std::string text = std::to_string(number);
    for (int at = int(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), ",");
    return text;
}

void count(const render::Ending& ending, const roots::FirstRoot& root, double footprint, int frame,
           Findings& found) {
    const roots::Fault fault =
        roots::judge(root, ending.is_known() && ending.is_hit(), double(ending.t), footprint);
    // A ray that may touch the surface and go on may be drawn either way.
    const bool is_open = root.answer == roots::Answer::touching && fault == roots::Fault::none;
    if (is_open || fault == roots::Fault::undecided) {
        ++found.undecided;
        return;
    }
    ++found.rays;
    if (fault == roots::Fault::none) return;
    ++found.wrong;
    if (found.examples.size() < most_examples)
        found.examples.push_back({frame, ending.column, ending.row, fault});
}

} // namespace

void Findings::add(const Findings& other) {
    rays += other.rays;
    undecided += other.undecided;
    wrong += other.wrong;
    for (const WrongPixel& pixel : other.examples) {
        if (examples.size() < most_examples) examples.push_back(pixel);
    }
}

double most_wrong(std::int64_t rays) {
    return rays > 0 ? -std::expm1(std::log(0.05) / double(rays)) : 1;
}

std::string words(const Findings& findings, int frames) {
    const std::string rays =
        fmt::format("audited {} ray{} of {} frame{}", with_commas(findings.rays),
                    findings.rays == 1 ? "" : "s", with_commas(frames), frames == 1 ? "" : "s");
    const std::string unknown =
        findings.undecided > 0
            ? fmt::format("; truth can't tell of {} more", with_commas(findings.undecided))
            : "";
    if (findings.wrong > 0)
        return fmt::format("{}: {} wrong{}", rays, with_commas(findings.wrong), unknown);
    if (findings.rays == 0) return rays + unknown;
    // The others are no random part of all: they meet the surface where it is touched or has an
    // edge.
    return fmt::format("{}: none wrong (at most {} in a million{}, 95 % sure){}", rays,
                       with_commas(std::llround(std::ceil(1e6 * most_wrong(findings.rays)))),
                       findings.undecided > 0 ? " of such rays" : "", unknown);
}

std::vector<int> pixels_of_frame(int width, int height, int count, int frame) {
    std::mt19937_64 random(std::uint64_t(frame) * 0x9E3779B97F4A7C15u);
    const std::uint64_t all = std::uint64_t(width) * std::uint64_t(height);
    // Floyd's sampling: each set of so many pixels is as likely as any other.
    std::set<int> chosen;
    for (std::uint64_t k = all - std::min(std::uint64_t(count), all); k < all; ++k) {
        if (!chosen.insert(int(random() % (k + 1))).second) chosen.insert(int(k));
    }
    return {chosen.begin(), chosen.end()};
}

Auditor::Auditor(const scene::Scene& scene)
    : scene_(scene) {
    for (const scene::Surface& surface : scene.surfaces) fields_.emplace_back(*surface.field);
}

namespace {

double operations_of(const scene::Surface& surface) {
    std::vector<int> counts = surface.animation.counts();
    if (const auto by_place = elements::FieldByPlace::of(*surface.field, counts)) {
        int& count = counts[std::size_t(by_place->array())];
        count = std::min(count, usual_list);
    }
    return formula::cost(surface.field->value, counts).operations;
}

} // namespace

double Auditor::operations_at_a_point() const {
    double sum = 0;
    for (const scene::Surface& surface : scene_.surfaces) sum += operations_of(surface);
    return sum;
}

Findings Auditor::hold(int frame, const scene::SceneAt& now, const scene::Aim& aim, int width,
                       int height, std::span<const render::Ending> endings,
                       const std::function<bool()>& stop,
                       std::shared_ptr<const elements::ElementGrid> grid) {
    const auto begin = std::chrono::steady_clock::now();
    const roots::RaysOfSurfaces rays(now, width, height, aim);
    std::vector<roots::Sections> sections;
    std::vector<roots::EnclosedField::Frame> fields;
    std::vector<roots::RootFinder> finders;
    for (std::size_t k = 0; k < fields_.size(); ++k) {
        sections.emplace_back(scene::OneSurfaceAt(now, k));
        fields.push_back(fields_[k].at(now.surfaces[k], 1, k == 0 ? std::move(grid) : nullptr));
    }
    finders.reserve(fields.size());
    for (const auto& field : fields) finders.push_back(field.finder(budget));
    Findings found;
    for (std::size_t first = 0; first < endings.size() && !(stop && stop());
         first += rays_together) {
        const auto some = endings.subspan(first, std::min(rays_together, endings.size() - first));
        std::vector<std::vector<roots::FirstRoot>> roots(fields_.size());
        for (std::size_t k = 0; k < fields_.size(); ++k) {
            std::vector<roots::Tube> of_rays;
            for (const render::Ending& ending : some)
                of_rays.push_back(rays.of(k).at(ending.column, ending.row));
            roots[k].resize(of_rays.size());
            roots::find_first(finders[k], sections[k], of_rays, roots[k]);
        }
        for (std::size_t at = 0; at < some.size(); ++at) {
            const render::Ending& ending = some[at];
            std::vector<roots::FirstRoot> of_surfaces;
            of_surfaces.reserve(roots.size());
            for (const auto& of_one : roots) of_surfaces.push_back(of_one[at]);
            count(ending, rays.nearest(ending.column, ending.row, of_surfaces),
                  rays.of(0).at(ending.column, ending.row).footprint, frame, found);
        }
        rays_ += std::int64_t(some.size());
    }
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return found;
}

int affordable(double drawing_seconds, double seconds_a_ray, double operations) {
    const double fewest = std::clamp(cheap_operations / (operations + 1), 0.0, fewest_rays);
    if (seconds_a_ray <= 0) return int(std::lround(fewest));
    const double paid = part_of_drawing * drawing_seconds / seconds_a_ray;
    return int(std::lround(std::clamp(paid, fewest, most_rays)));
}

} // namespace isomotion::audit
