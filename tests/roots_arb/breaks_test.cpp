// Truth of random formulas with kinks, jumps and poles asked again in 200 bits, ray by ray, and
// closest by where they are: between two pixels whose rays end otherwise the place where that
// changes is narrowed down, and each ray on the way is checked.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/random/families.h"
#include "roots/first_root.h"
#include "scene/reading/load.h"
#include "thin_ray.h"

namespace isomotion::roots_arb {
namespace {

using roots::Answer;

constexpr int side = 10;        // pixels of the coarse picture
constexpr int finer = 1 << 14;  // that each is cut into, across
constexpr int narrowed = 4;     // neighbours of a scene whose change is narrowed down
constexpr int most_breaks = 40; // of one ray
constexpr int pieces_a_search = 600;

struct Counts {
    int answers[4]{}; // of truth
    int proven = 0;   // rays of which Arb says the same
    int open = 0;     // ... can't say
    // Changes of sign across jumps and poles, and at roots in what truth leaves open.
    int breaks = 0, roots = 0;
};

class Rays {
public:
    Rays(const scene::Scene& scene, Counts& counts)
        : now_(scene::at_frame(scene, 1))
        , programs_(formula::enclosure_programs(*scene.surfaces[0].field))
        , value_(programs_.value)
        , bindings_(formula::convert<double>(now_.surfaces[0].bindings))
        , balls_(programs_, now_.surfaces[0].bindings)
        , finder_(programs_, now_.surfaces[0], {.evaluations = 4000})
        , tubes_(now_, side * finer, side * finer)
        , counts_(counts) {}

    // How a ray ends: its answer, and how many breaks Arb met.
    using End = std::pair<Answer, int>;

    End check(std::array<int, 2> pixel) {
        const roots::Tube tube = tubes_.at(pixel[0], pixel[1]);
        if (!(tube.near <= tube.far)) return {Answer::miss, 0};
        roots::FirstRoot root;
        finder_.find({&tube, 1}, {&root, 1});
        ++counts_.answers[int(root.answer)];
        breaks_ = 0;
        bool proven = is_free(tube, tube.near,
                              root.answer == Answer::miss       ? tube.far
                              : root.answer == Answer::touching ? root.touch_low
                                                                : root.low);
        if (root.answer == Answer::touching) {
            proven &= is_free(tube, root.touch_high, root.after_is_hit ? root.low : tube.far);
            search_touch(middle(tube), root.touch_low, root.touch_high);
        }
        if (root.answer == Answer::hit || root.after_is_hit) check_bracket(tube, root);
        ++(proven ? counts_.proven : counts_.open);
        counts_.breaks += breaks_;
        return {root.answer, breaks_};
    }

private:
    static Ray middle(const roots::Tube& tube) { return {tube.anchor, tube.direction}; }

    // Whether F is continuous over a change of sign between two doubles that are close: it is as
    // small over all of it as it is at its ends. At a jump or pole it isn't.
    bool is_continuous(const Ray& ray, double low, double high) {
        return value_over(ray, low, high).is_in(-1e-6, 1e-6);
    }

    Ball value_over(const Ray& ray, double low, double high) {
        const Ball t(low, high);
        std::array<Ball, 3> p;
        for (int k = 0; k < 3; ++k) {
            p[std::size_t(k)] = Ball(ray.anchor[k]);
            arb_addmul(p[std::size_t(k)].get(), Ball(ray.direction[k]).get(), t.get(), 200);
        }
        Ball f;
        value_.evaluate(bindings_, p, {&f, 1}, 200);
        return f;
    }

    // Whether F has no bounds between two doubles that are close.
    bool is_pole(const Ray& ray, double low, double high) {
        const Ball f = value_over(ray, low, high);
        return !f.is_in(-1e6, 1e6);
    }

    // Whether Arb, too, finds neither a root nor a break there. A root is a failure, and so is a
    // jump; poles are told from roots.
    bool is_free(const roots::Tube& tube, double from, double to) {
        bool is_proven = true;
        for (int k = 0; from < to && k < most_breaks; ++k) {
            const Search search = balls_.search(middle(tube), from, to, pieces_a_search);
            is_proven &= search.unproven == 0;
            if (!search.crosses) return is_proven;
            EXPECT_TRUE(is_pole(middle(tube), search.low, search.high))
                << "F changes its sign between " << search.low << " and " << search.high
                << ", where truth has no root";
            ++breaks_;
            from = search.high;
        }
        return is_proven;
    }

    // What truth leaves open is a root, a jump or a pole, or none of them.
    void search_touch(const Ray& ray, double from, double to) {
        for (int k = 0; from < to && k < most_breaks; ++k) {
            const Search search = balls_.search(ray, from, to, pieces_a_search);
            if (!search.crosses) return;
            ++(is_continuous(ray, search.low, search.high) ? counts_.roots : breaks_);
            from = search.high;
        }
    }

    void check_bracket(const roots::Tube& tube, const roots::FirstRoot& root) {
        const Ray ray = middle(tube);
        EXPECT_LT(balls_.sign_at(ray, double(root.low)) * balls_.sign_at(ray, double(root.high)), 0)
            << "no change of sign between " << root.low << " and " << root.high;
        const Search search = balls_.search(ray, double(root.low), double(root.high), 300);
        EXPECT_TRUE(!search.crosses || is_continuous(ray, search.low, search.high))
            << "a jump or a pole between " << search.low << " and " << search.high;
    }

    scene::SceneAt now_;
    formula::EnclosurePrograms programs_;
    BallProgram value_;
    formula::Bindings<double> bindings_;
    ThinRays balls_;
    roots::RootFinder finder_;
    roots::Tubes tubes_;
    Counts& counts_;
    int breaks_ = 0;
};

void check_scene(const scene::Scene& scene, Counts& counts) {
    Rays rays(scene, counts);
    std::array<std::array<Rays::End, side>, side> ends;
    const auto middle_of = [](int k) { return k * finer + finer / 2; };
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column)
            ends[std::size_t(row)][std::size_t(column)] =
                rays.check({middle_of(column), middle_of(row)});
    }
    int left = narrowed;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column + 1 < side && left > 0; ++column) {
            const Rays::End here = ends[std::size_t(row)][std::size_t(column)];
            if (here == ends[std::size_t(row)][std::size_t(column) + 1]) continue;
            --left;
            int low = middle_of(column), high = middle_of(column + 1);
            while (high - low > 1) {
                const int middle = (low + high) / 2;
                (rays.check({middle, middle_of(row)}) == here ? low : high) = middle;
            }
        }
    }
}

class Breaks : public testing::TestWithParam<const char*> {
protected:
    void check_scenes(int formulas) {
        const auto families = bench::families();
        const auto family =
            std::ranges::find(families, std::string_view(GetParam()), &bench::Family::name);
        ASSERT_NE(family, families.end());
        constexpr std::uint64_t seed = 230;
        Counts counts;
        for (int k = 0; k < formulas && !HasFailure(); ++k) {
            const std::string text = bench::random_scene(*family, seed + std::uint64_t(k), 64);
            SCOPED_TRACE(text);
            check_scene(scene::load_text(text, "random.toml", {}, scene::Reach::own_folder),
                        counts);
        }
        fmt::print("{}: {} miss, {} hit, {} touching, {} undecided; Arb agrees on {}, can't say of "
                   "{}; there are {} jumps and poles, and truth leaves open {} roots\n",
                   GetParam(), counts.answers[0], counts.answers[1], counts.answers[2],
                   counts.answers[3], counts.proven, counts.open, counts.breaks, counts.roots);
        EXPECT_GT(counts.answers[0], 0);
        EXPECT_GT(counts.answers[1], 0);
        // Arb proves no piece that holds a pole.
        const std::string_view name = GetParam();
        EXPECT_GT(counts.proven, (name == "pole" ? 3 : 9) * counts.open);
        EXPECT_TRUE(counts.breaks > 0 || (name != "pole" && name != "jump"));
    }
};

class BreaksExhaustive : public Breaks {};

TEST_P(Breaks, AreAsBallsSay) { check_scenes(3); }
TEST_P(BreaksExhaustive, AreAsBallsSay) { check_scenes(60); }

constexpr std::array classes{"csg", "shell", "power", "pole", "sum", "jump"};
INSTANTIATE_TEST_SUITE_P(Balls, Breaks, testing::ValuesIn(classes));
INSTANTIATE_TEST_SUITE_P(Balls, BreaksExhaustive, testing::ValuesIn(classes));

} // namespace
} // namespace isomotion::roots_arb
