#include "roots/certify.h"

#include <mutex>
#include <thread>

#include "base/workers.h"
#include "roots/cut_rays.h"
#include "roots/field_at_frame.h"
#include "roots/nearest.h"

namespace isomotion::roots {

std::array<std::int64_t, 4> Truth::counts() const {
    std::array<std::int64_t, 4> counts{};
    for (const FirstRoot& root : roots) ++counts[std::size_t(root.answer)];
    return counts;
}

namespace {

Truth certify_one(const formula::Field& field, const scene::OneSurfaceAt& now, int width,
                  int height, const Certifying& how) {
    const int wanted = how.threads > 0 ? how.threads : int(std::thread::hardware_concurrency());
    EnclosedField enclosed(field);
    const EnclosedField::Frame frame = enclosed.at(now.surface, wanted);
    const Tubes tubes(now, width, height);
    const Sections sections(now);
    Truth truth{width, height, {}, 0};
    truth.roots.resize(std::size_t(width) * std::size_t(height));

    std::mutex counting;
    base::share({.count = std::size_t(height), .threads = wanted, .progress = how.progress}, [&] {
        return [&, finder = frame.finder(how.budget),
                row_of_tubes = std::vector<Tube>(std::size_t(width))](std::size_t row) mutable {
            for (int column = 0; column < width; ++column) {
                row_of_tubes[std::size_t(column)] = tubes.at(column, int(row));
            }
            const std::int64_t before = finder.evaluations();
            const std::span<FirstRoot> roots =
                std::span(truth.roots).subspan(row * std::size_t(width), std::size_t(width));
            find_first(finder, sections, row_of_tubes, roots);
            finder.gradients(row_of_tubes, roots);
            const std::lock_guard lock(counting);
            truth.evaluations += finder.evaluations() - before;
        };
    });
    return truth;
}

} // namespace

Truth certify(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
              const Certifying& how) {
    const std::size_t count = scene.surfaces.size();
    std::vector<Truth> each;
    Truth all{width, height, {}, 0};
    for (std::size_t k = 0; k < count; ++k) {
        Certifying one = how;
        if (how.progress)
            one.progress = [&](double part) { how.progress((double(k) + part) / double(count)); };
        each.push_back(certify_one(*scene.surfaces[k].field, {now, k}, width, height, one));
        all.evaluations += each.back().evaluations;
    }
    if (count == 1) return std::move(each.front());
    const RaysOfSurfaces rays(now, width, height);
    std::vector<FirstRoot> roots(count);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            for (std::size_t k = 0; k < count; ++k) roots[k] = each[k].at(column, row);
            all.roots.push_back(rays.nearest(column, row, roots));
        }
    }
    return all;
}

} // namespace isomotion::roots
