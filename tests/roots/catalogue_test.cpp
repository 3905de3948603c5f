// Every surface of the catalogue: what is certified of its rays against dense samples in double.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

#include "formula/field.h"
#include "scene/data_folder.h"
#include "view.h"

namespace isomotion::roots {
namespace {

void use_source_tree() { setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1); }

// F in double along the middle ray of a tube.
class Samples {
public:
    explicit Samples(const View& view)
        : value_(view.scene.surfaces[0].field->value)
        , bindings_(formula::convert<double>(view.now.surfaces[0].bindings)) {}

    double at(const Tube& tube, double t) {
        const glm::dvec3 p = tube.anchor + t * tube.direction;
        const std::array<double, 3> inputs{p.x, p.y, p.z};
        double f = 0;
        value_.point(bindings_, inputs, {&f, 1});
        return f;
    }

    // Where the sign is found to change in (from, to), or NaN. Looks at `count` samples, and closer
    // wherever they come near to zero and leave it again.
    double change(const Tube& tube, double from, double to, int count) {
        const auto size = std::size_t(count);
        for (auto& coordinate : p_) coordinate.resize(size);
        f_.resize(size);
        const double step = (to - from) / (count + 1);
        const auto t = [&](std::size_t k) { return from + double(k + 1) * step; };
        for (std::size_t k = 0; k < size; ++k) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                p_[axis][k] = tube.anchor[int(axis)] + t(k) * tube.direction[int(axis)];
            }
        }
        const std::array<std::span<const double>, 3> inputs{p_[0], p_[1], p_[2]};
        const std::array<std::span<double>, 1> outputs{f_};
        value_.points(bindings_, inputs, outputs);
        for (std::size_t k = 1; k < size; ++k) {
            if ((f_[k] < 0) != (f_[0] < 0)) return t(k);
        }
        const double sign = f_[0] < 0 ? -1 : 1;
        for (std::size_t k = 1; k + 1 < size; ++k) {
            const double before = sign * f_[k - 1], here = sign * f_[k], after = sign * f_[k + 1];
            if (here > before || here >= after) continue;
            // A parabola through the three may reach zero, generously.
            const double bend = before - 2 * here + after, tilt = after - before;
            if (here > tilt * tilt / (2 * bend) + bend) continue;
            const double crossing = dip(tube, t(k - 1), t(k + 1), sign);
            if (!std::isnan(crossing)) return crossing;
        }
        return NAN;
    }

private:
    // The least value of sign * F between, by thirds: where it is below zero, or NaN.
    double dip(const Tube& tube, double low, double high, double sign) {
        for (int k = 0; k < 24; ++k) {
            const double a = low + (high - low) / 3, b = high - (high - low) / 3;
            const double at_a = sign * at(tube, a), at_b = sign * at(tube, b);
            if (at_a < 0) return a;
            if (at_b < 0) return b;
            (at_a < at_b ? high : low) = at_a < at_b ? b : a;
        }
        return NAN;
    }

    formula::Evaluator<double> value_;
    formula::Bindings<double> bindings_;
    std::array<std::vector<double>, 3> p_;
    std::vector<double> f_;
};

constexpr int samples_of_a_ray = 4000;

// What is certain of a ray must not be contradicted.
void expect_uncontradicted(Samples& samples, const Tube& tube, const FirstRoot& root) {
    const auto expect_free = [&](double from, double to) {
        if (!(from < to)) return;
        const int count = std::max(3, int(samples_of_a_ray * (to - from) / (tube.far - tube.near)));
        const double change = samples.change(tube, from, to, count);
        EXPECT_TRUE(std::isnan(change))
            << "the sign changes at " << change << " in [" << from << ", " << to << "]";
    };
    const auto expect_crossing = [&](double low, double high) {
        const double before = samples.at(tube, low), behind = samples.at(tube, high);
        EXPECT_LT(std::copysign(1, before) * std::copysign(1, behind), 0)
            << "F is " << before << " and " << behind;
    };
    switch (root.answer) {
    case Answer::miss:
        expect_free(tube.near, tube.far);
        break;
    case Answer::hit:
        expect_free(tube.near, root.low);
        expect_crossing(root.low, root.high);
        break;
    case Answer::touching:
        expect_free(tube.near, root.touch_low);
        expect_free(root.touch_high, root.after_is_hit ? double(root.low) : tube.far);
        if (root.after_is_hit) expect_crossing(root.low, root.high);
        break;
    case Answer::undecided:
        expect_free(tube.near, root.low);
        break;
    }
}

void expect_uncontradicted(const View& view) {
    Samples samples(view);
    for (std::size_t k = 0; k < view.roots.size(); ++k) {
        if (!(view.tubes[k].near <= view.tubes[k].far)) continue;
        SCOPED_TRACE(fmt::format("pixel {}: {}", k, testing::PrintToString(view.roots[k])));
        expect_uncontradicted(samples, view.tubes[k], view.roots[k]);
        if (testing::Test::HasFailure()) return; // one is enough to read
    }
}

int count(const View& view, Answer answer) {
    return int(std::count_if(view.roots.begin(), view.roots.end(),
                             [&](const FirstRoot& root) { return root.answer == answer; }));
}

constexpr int side = 48;

// Some of their rays cannot be told from ones that touch: the surface really has a double line, or
// the formula's terms cancel all digits that float32 leaves of a point.
const std::set<std::string> rather_uncertain{"chmutov_22_power", "high_silhouette", "nonisol"};

// The surface with its bounds filling the picture, from a direction that is special to none.
View picture_of(const std::string& surface) {
    const std::string use = fmt::format("[surface]\nuse = \"{}\"\n", surface);
    const scene::Scene scene = scene_of(use);
    const scene::BoundsAt bounds = scene::at_frame(scene, 1).surfaces[0].bounds;
    const glm::dvec3 &to = bounds.centre,
                     from = to + 3 * bounds.radius * glm::normalize(glm::dvec3(0.53, -0.71, 0.43));
    return View(scene_of(use + fmt::format("[camera]\nposition = [{}, {}, {}]\n"
                                           "target = [{}, {}, {}]\nup = [0, 0, 1]\nfov = 40\n",
                                           from.x, from.y, from.z, to.x, to.y, to.z)),
                side, side);
}

class CatalogueTruth : public testing::TestWithParam<std::string> {};

TEST_P(CatalogueTruth, IsNotContradictedByDenseSamples) {
    use_source_tree();
    const View view = picture_of(GetParam());
    expect_uncontradicted(view);
    // In powers the terms of T_22 cancel, and the budget of some rays ends before they are told.
    EXPECT_LE(count(view, Answer::undecided),
              GetParam() == "chmutov_22_power" ? side * side / 30 : 0);
    EXPECT_GT(count(view, Answer::hit) + count(view, Answer::touching), side * side / 20);
    if (!rather_uncertain.contains(GetParam())) {
        EXPECT_LE(count(view, Answer::touching), side * side / 50);
    }
}

std::vector<std::string> surfaces() {
    use_source_tree();
    return scene::surface_names();
}
INSTANTIATE_TEST_SUITE_P(Surfaces, CatalogueTruth, testing::ValuesIn(surfaces()),
                         [](const auto& instance) { return instance.param; });

TEST(AnimationTruth, IsNotContradictedByDenseSamples) {
    use_source_tree();
    for (const char* name : {"blobby75", "twisting_superquadric"}) {
        for (const int frame : {1, 38}) {
            SCOPED_TRACE(fmt::format("{}, frame {}", name, frame));
            const View view(scene::load(name), side, side, {}, frame);
            expect_uncontradicted(view);
            EXPECT_EQ(count(view, Answer::undecided), 0);
            EXPECT_EQ(count(view, Answer::touching), 0);
        }
    }
}

} // namespace
} // namespace isomotion::roots
