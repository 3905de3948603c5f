// Pictures of certified roots: threads, progress and budgets.
#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "view.h"

namespace isomotion::roots {
namespace {

constexpr int width = 37, height = 23;

// Hits, misses, a double plane and a sheet that grazes: all answers but `undecided`.
const std::string text = R"(
[surface]
formula = '(x^2 + y^2 + z^2 - 1)*(x - 0.25)^2*(z - 0.5)'
bounds = { sphere = 1.5 }
[camera]
position = [2.1, -1.7, 3.3]
fov = 50
)";

struct Subject {
    scene::Scene scene = scene_of(text);
    scene::SceneAt now = scene::at_frame(scene, 1);

    Truth certified(const Certifying& how = {}) const {
        return certify(scene, now, width, height, how);
    }
};

Certifying on(int threads, std::function<void(double)> progress = {}) {
    return {Budget{}, threads, std::move(progress)};
}

bool same(const FirstRoot& a, const FirstRoot& b) {
    return a.answer == b.answer && a.after_is_hit == b.after_is_hit && a.low == b.low &&
           a.high == b.high && a.touch_low == b.touch_low && a.touch_high == b.touch_high;
}

TEST(Certify, IsTheSameForAnyNumberOfThreads) {
    const Subject subject;
    const Truth one = subject.certified(on(1));
    const auto counts = one.counts();
    EXPECT_GT(counts[std::size_t(Answer::miss)], 0);
    EXPECT_GT(counts[std::size_t(Answer::hit)], 0);
    EXPECT_GT(counts[std::size_t(Answer::touching)], 0);
    for (const int threads : {2, 3, 64, 0}) {
        SCOPED_TRACE(threads);
        const Truth other = subject.certified(on(threads));
        EXPECT_EQ(other.width, width);
        EXPECT_EQ(other.height, height);
        EXPECT_EQ(other.evaluations, one.evaluations);
        EXPECT_TRUE(std::equal(one.roots.begin(), one.roots.end(), other.roots.begin(),
                               other.roots.end(), same));
    }
}

TEST(Certify, HasTheRootOfEachTubeAtItsPixel) {
    const Subject subject;
    const Truth truth = subject.certified();
    const View view(scene_of(text), width, height);
    ASSERT_EQ(truth.roots.size(), view.roots.size());
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            EXPECT_TRUE(same(truth.at(column, row), view.roots[std::size_t(row * width + column)]))
                << column << ", " << row;
        }
    }
}

TEST(Certify, TellsItsProgressFromZeroToOne) {
    const Subject subject;
    for (const int threads : {1, 3}) {
        SCOPED_TRACE(threads);
        std::vector<double> parts;
        std::atomic<int> at_once = 0;
        bool alone = true;
        subject.certified(on(threads, [&](double part) {
            alone = alone && ++at_once == 1;
            parts.push_back(part);
            std::this_thread::yield();
            --at_once;
        }));
        EXPECT_TRUE(alone);
        ASSERT_FALSE(parts.empty());
        EXPECT_GT(parts.front(), 0);
        EXPECT_EQ(parts.back(), 1);
        EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
        EXPECT_EQ(std::adjacent_find(parts.begin(), parts.end()), parts.end());
    }
}

TEST(Certify, HandsOnWhatProgressThrows) {
    const Subject subject;
    for (const int threads : {1, 3}) {
        const Certifying how = on(threads, [](double) { throw std::runtime_error("enough"); });
        EXPECT_THROW(subject.certified(how), std::runtime_error);
    }
}

TEST(Certify, CountsEvaluations) {
    const Subject subject;
    const Truth truth = subject.certified();
    const auto counts = truth.counts();
    const std::int64_t rays = std::int64_t(truth.roots.size());
    EXPECT_EQ(counts[0] + counts[1] + counts[2] + counts[3], rays);
    EXPECT_GT(truth.evaluations, 3 * (counts[1] + counts[2]));
    // A narrower bracket costs more.
    Certifying finer;
    finer.budget.bracket = 1e-5;
    EXPECT_GT(subject.certified(finer).evaluations, truth.evaluations);
    // Rays that pass the bounds by cost nothing.
    const scene::Scene aside = scene_of("[surface]\nformula = 'x'\nbounds = { sphere = 1 }\n"
                                        "[camera]\nposition = [0, 0, 9]\ntarget = [0, 9, 9]\n");
    EXPECT_EQ(certify(aside, scene::at_frame(aside, 1), 8, 8).evaluations, 0);
}

TEST(Certify, KeepsToItsBudgetWithoutAGuess) {
    const Subject subject;
    const Truth full = subject.certified();
    std::int64_t most_decided = -1;
    for (const int evaluations : {1, 10, 40, 160, 640}) {
        SCOPED_TRACE(evaluations);
        Certifying how;
        how.budget.evaluations = evaluations;
        const Truth hasty = subject.certified(how);
        const auto counts = hasty.counts();
        const std::int64_t decided =
            std::int64_t(hasty.roots.size()) - counts[std::size_t(Answer::undecided)];
        EXPECT_GE(decided, most_decided);
        most_decided = decided;
        // One round of the march may take a ray past its budget: a point, the gradient there and
        // a piece.
        EXPECT_LE(hasty.evaluations, std::int64_t(hasty.roots.size()) * (evaluations + 3));
        for (std::size_t k = 0; k < full.roots.size(); ++k) {
            const FirstRoot &root = hasty.roots[k], &known = full.roots[k];
            if (root.answer != Answer::undecided) {
                EXPECT_TRUE(same(root, known)) << "pixel " << k;
                continue;
            }
            // What is before its `low` is free of roots.
            if (known.answer == Answer::hit) {
                EXPECT_LE(root.low, known.high) << "pixel " << k;
            } else if (known.answer == Answer::touching) {
                EXPECT_LE(root.low, known.touch_low) << "pixel " << k;
            }
        }
        if (evaluations <= 10) {
            EXPECT_GT(counts[std::size_t(Answer::undecided)], 200);
        }
        if (evaluations == 1) {
            EXPECT_EQ(counts[std::size_t(Answer::hit)], 0);
        }
    }
}

} // namespace
} // namespace isomotion::roots
