#include "truth/certify.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

namespace isomotion::truth {

std::array<std::int64_t, 4> Truth::counts() const {
    std::array<std::int64_t, 4> counts{};
    for (const FirstRoot& root : roots) ++counts[std::size_t(root.answer)];
    return counts;
}

Truth certify(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
              const Certifying& how) {
    const formula::EnclosurePrograms field = formula::enclosure_programs(*scene.surface.field);
    const Tubes tubes(now, width, height);
    Truth truth{width, height, {}, 0};
    truth.roots.resize(std::size_t(width) * std::size_t(height));

    std::atomic<int> next_row = 0;
    std::mutex mutex; // of what follows, and of progress
    int finished_rows = 0;
    std::exception_ptr failure;
    const auto work = [&] {
        try {
            RootFinder finder(field, now, how.budget);
            std::vector<Tube> row_of_tubes(static_cast<std::size_t>(width));
            for (int row = next_row++; row < height; row = next_row++) {
                for (int column = 0; column < width; ++column) {
                    row_of_tubes[std::size_t(column)] = tubes.at(column, row);
                }
                const std::size_t first = std::size_t(row) * std::size_t(width);
                finder.find(row_of_tubes,
                            std::span(truth.roots).subspan(first, std::size_t(width)));
                const std::lock_guard lock(mutex);
                ++finished_rows;
                if (how.progress) how.progress(double(finished_rows) / height);
            }
            const std::lock_guard lock(mutex);
            truth.evaluations += finder.evaluations();
        } catch (...) {
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
        }
    };
    const int wanted = how.threads > 0 ? how.threads : int(std::thread::hardware_concurrency());
    std::vector<std::thread> threads;
    for (int k = 1; k < std::clamp(wanted, 1, height); ++k) threads.emplace_back(work);
    work();
    for (auto& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
    return truth;
}

} // namespace isomotion::truth
