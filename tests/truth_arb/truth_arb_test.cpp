// Certified ray casting (src/truth) asked again in 200 bits: for every pixel the tube's middle, one
// exact ray, must be as truth says of all rays of the tube.
//
// Where truth leaves an answer open, the thin ray shows what it lacks: if balls decide, the tube's
// thickness or the doubles did.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scenes.h"
#include "thin_ray.h"
#include "truth/certify.h"

namespace isomotion::truth_arb {
namespace {

using truth::Answer;
using truth::FirstRoot;

constexpr int side = 24;
constexpr int pieces_a_ray = 3000;

struct Tally {
    int hits = 0, misses = 0, touching = 0, undecided = 0;
    int proven = 0;                         // rays whose parts without roots are so for Arb
    int open = 0;                           // ... that Arb could not prove free
    int brackets = 0;                       // hits whose ends have opposite signs
    int as_hit = 0, as_miss = 0, still = 0; // touching and undecided ones, decided by Arb
    int contradictions = 0;

    void add(const Tally& other) {
        hits += other.hits;
        misses += other.misses;
        touching += other.touching;
        undecided += other.undecided;
        proven += other.proven;
        open += other.open;
        brackets += other.brackets;
        as_hit += other.as_hit;
        as_miss += other.as_miss;
        still += other.still;
        contradictions += other.contradictions;
    }
    void print(std::string_view name) const {
        fmt::print("{:24}{:7}{:7}{:7}{:7}{:7}{:7}{:7}{:7}{:7}{:7}{:7}\n", name, hits, misses,
                   brackets, proven, open, touching, undecided, as_hit, as_miss, still,
                   contradictions);
    }
    static void print_head() {
        fmt::print("{:24}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}\n", "", "hit",
                   "miss", "ends", "free", "open", "touch", "undec", "=hit", "=miss", "=?",
                   "against");
    }
};

class CertifiedRays : public testing::TestWithParam<std::string> {
protected:
    static void SetUpTestSuite() { Tally::print_head(); }
    static void TearDownTestSuite() { total.print("total"); }

    void check(const truth::Tube& tube, const FirstRoot& root, ThinRays& rays) {
        const Ray ray{tube.anchor, tube.direction};
        const auto is_free = [&](double from, double to) {
            if (!(from < to)) return true;
            const Search search = rays.search(ray, from, to, pieces_a_ray);
            if (search.crosses) {
                ++tally.contradictions;
                ADD_FAILURE() << "F changes its sign between " << search.low << " and "
                              << search.high << ", where truth knows of no root";
            }
            return search.unproven == 0;
        };
        bool proven = true;
        switch (root.answer) {
        case Answer::miss:
            ++tally.misses;
            proven = is_free(tube.near, tube.far);
            break;
        case Answer::hit:
            ++tally.hits;
            proven = is_free(tube.near, root.low);
            check_bracket(ray, root, rays);
            break;
        case Answer::touching:
            ++tally.touching;
            proven = is_free(tube.near, root.touch_low) &&
                     is_free(root.touch_high, root.after_is_hit ? root.low : tube.far);
            if (root.after_is_hit) check_bracket(ray, root, rays);
            decide(tube, root, rays);
            break;
        case Answer::undecided:
            ++tally.undecided;
            proven = is_free(tube.near, root.low);
            decide(tube, root, rays);
            break;
        }
        ++(proven ? tally.proven : tally.open);
    }

    // What truth says holds for every ray of the tube, the middle included, so the tube's thickness
    // needs no room here; low and high are rounded outwards to floats.
    void check_bracket(const Ray& ray, const FirstRoot& root, ThinRays& rays) {
        const int ends = rays.sign_at(ray, root.low) * rays.sign_at(ray, root.high);
        if (ends < 0) {
            ++tally.brackets;
            return;
        }
        ++tally.contradictions;
        ADD_FAILURE() << "no change of sign between " << root.low << " and " << root.high;
    }

    void decide(const truth::Tube& tube, const FirstRoot& root, ThinRays& rays) {
        const Ray ray{tube.anchor, tube.direction};
        const Search search = rays.search(ray, tube.near, tube.far, pieces_a_ray);
        if (search.unproven > 0) {
            ++tally.still;
            return;
        }
        ++(search.crosses ? tally.as_hit : tally.as_miss);
        if (root.answer == Answer::undecided) return;
        EXPECT_FALSE(root.after_is_hit && !search.crosses) << "a certain hit is none";
        const auto inside = [&](float low, float high) {
            return low <= search.high && search.low <= high;
        };
        EXPECT_TRUE(!search.crosses || inside(root.touch_low, root.touch_high) ||
                    (root.after_is_hit && inside(root.low, root.high)))
            << "the first root, " << search.low << ", is where truth knows of none";
    }

    Tally tally;
    static inline Tally total;
};

TEST_P(CertifiedRays, AreAsBallsSay) {
    const catalogue::Used scene = scene_named(GetParam());
    const truth::Truth truth = truth::certify(scene.scene, scene.at, side, side);
    const truth::Tubes tubes(scene.at, side, side);
    const formula::EnclosurePrograms field = formula::enclosure_programs(scene.field());
    ThinRays rays(field, scene.at.bindings);
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            SCOPED_TRACE(fmt::format("column {} row {}", column, row));
            const truth::Tube tube = tubes.at(column, row);
            if (tube.near <= tube.far) check(tube, truth.at(column, row), rays);
        }
    }
    tally.print(GetParam());
    total.add(tally);
    EXPECT_EQ(tally.contradictions, 0);
    EXPECT_GT(tally.proven, 0);
    RecordProperty("as_hit", tally.as_hit);
    RecordProperty("as_miss", tally.as_miss);
    RecordProperty("still_undecided", tally.still);
}

INSTANTIATE_TEST_SUITE_P(Balls, CertifiedRays, testing::ValuesIn(every_scene()),
                         [](const auto& scene) { return scene.param; });

} // namespace
} // namespace isomotion::truth_arb
