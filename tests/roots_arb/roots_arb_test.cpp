// Certified ray casting (src/roots) asked again in 200 bits: for every pixel the tube's middle, one
// exact ray, must be as truth says of all rays of the tube.
//
// Where truth leaves an answer open, balls say what the middle does, and truth asked again with
// less to allow for says what kept it from deciding.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "roots/certify.h"
#include "scenes.h"
#include "thin_ray.h"
#include "thorough.h"

namespace isomotion::roots_arb::roots_arb_test {
namespace {

using roots::Answer;
using roots::FirstRoot;

const int side = is_thorough() ? 24 : 16;
constexpr int pieces_a_ray = 3000;
constexpr int causes_a_scene = 20; // about so many open answers are asked for their cause

enum class Count {
    hit, // answers of truth
    miss,
    touching,
    undecided,
    bracket, // brackets of hits at whose ends Arb has opposite signs
    proven,  // rays that Arb finds free of roots where truth does
    open,    // ... where it can't say
    // Touching and undecided ones, by what Arb says of the middle.
    as_hit,
    as_miss,
    still_open,
    // A sample of those it decides, by what lets truth decide too, each added to what is before it.
    ends,      // the shader's interval ends where the tube's middle leaves the bounds
    shorter,   // shorter pieces are told from zero
    thickness, // the tube is thin
    balls,     // nothing: doubles, and how their intervals widen, are the limit
    contradiction,
    count
};
constexpr std::array titles{"hit",   "miss", "touch", "undec", "bracket", "free",  "open",   "=hit",
                            "=miss", "=?",   "ends",  "short", "thin",    "balls", "against"};
static_assert(titles.size() == std::size_t(Count::count));

struct Tally {
    std::array<int, titles.size()> counts{};

    int& operator[](Count which) { return counts[std::size_t(which)]; }
    void add(const Tally& other) {
        for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += other.counts[k];
    }
    void print(std::string_view name) const {
        fmt::print("{:22}", name);
        for (const int count : counts) fmt::print("{:8}", count);
        fmt::print("\n");
    }
    static void print_head() {
        fmt::print("{:22}", "");
        for (const char* title : titles) fmt::print("{:>8}", title);
        fmt::print("\n");
    }
};

bool is_decided(const FirstRoot& root) {
    return root.answer == Answer::hit || root.answer == Answer::miss;
}

class CertifiedRays : public testing::TestWithParam<std::string> {
protected:
    static void SetUpTestSuite() { Tally::print_head(); }
    static void TearDownTestSuite() { total.print("total"); }

    CertifiedRays()
        : scene(scene_named(GetParam()))
        , programs(formula::enclosure_programs(scene.field()))
        , rays(programs, scene.at.surfaces[0].bindings)
        , finder(programs, scene.at.surfaces[0])
        , patient_finder(programs, scene.at.surfaces[0],
                         {.narrow = 0x1p-30, .narrowest = 0x1p-30}) {}

    void check(const roots::Tube& tube, const FirstRoot& root) {
        bool proven = true;
        switch (root.answer) {
        case Answer::miss:
            ++tally[Count::miss];
            proven = is_free(tube, tube.near, tube.far);
            break;
        case Answer::hit:
            ++tally[Count::hit];
            proven = is_free(tube, tube.near, root.low);
            check_bracket(tube, root);
            break;
        case Answer::touching:
            ++tally[Count::touching];
            proven = is_free(tube, tube.near, root.touch_low);
            proven &= is_free(tube, root.touch_high, root.after_is_hit ? root.low : tube.far);
            if (root.after_is_hit) check_bracket(tube, root);
            decide(tube, root);
            break;
        case Answer::undecided:
            ++tally[Count::undecided];
            proven = is_free(tube, tube.near, root.low);
            decide(tube, root);
            break;
        }
        ++tally[proven ? Count::proven : Count::open];
    }

    bool is_free(const roots::Tube& tube, double from, double to) {
        if (!(from < to)) return true;
        const Search search = rays.search(middle(tube), from, to, pieces_a_ray);
        if (search.crosses) {
            contradicts(fmt::format("F changes its sign between {} and {}, where truth has no root",
                                    search.low, search.high));
        }
        return search.unproven == 0;
    }

    // What truth says holds for every ray of the tube, so its thickness needs no room here; low and
    // high are floats, rounded outwards.
    void check_bracket(const roots::Tube& tube, const FirstRoot& root) {
        const Ray ray = middle(tube);
        if (rays.sign_at(ray, root.low) * rays.sign_at(ray, root.high) < 0) {
            ++tally[Count::bracket];
        } else {
            contradicts(fmt::format("no change of sign from {} to {}", root.low, root.high));
        }
    }

    void decide(const roots::Tube& tube, const FirstRoot& root) {
        const Search search = rays.search(middle(tube), tube.near, tube.far, pieces_a_ray);
        if (search.unproven > 0) {
            ++tally[Count::still_open];
            return;
        }
        ++tally[search.crosses ? Count::as_hit : Count::as_miss];
        check_place(root, search);

        if (open_answers++ % open_answers_a_cause == 0) count_cause(tube, search);
    }

    void count_cause(const roots::Tube& tube, const Search& search) {
        roots::Tube easier = tube;
        easier.near_inside = tube.near;
        easier.far_inside = tube.far;
        roots::Tube thin = easier;
        // Room for the rounding of doubles, whose unit is 2^-29 of float's, in place of float's.
        thin.radius *= 0x1p-26;
        thin.direction_radius *= 0x1p-26;
        if (is_decided(find(finder, easier))) {
            ++tally[Count::ends];
        } else if (is_decided(find(patient_finder, easier))) {
            ++tally[Count::shorter];
        } else if (const FirstRoot in_doubles = find(patient_finder, thin);
                   is_decided(in_doubles)) {
            ++tally[Count::thickness];
            if ((in_doubles.answer == Answer::hit) != search.crosses) {
                contradicts("truth decides otherwise on a thin tube");
            }
        } else {
            ++tally[Count::balls];
        }
    }

    // The middle's first root is where truth has one.
    void check_place(const FirstRoot& root, const Search& search) {
        const auto meets = [&](double low, double high) {
            return search.crosses && low <= search.high && search.low <= high;
        };
        const bool may_miss = !root.after_is_hit && !search.crosses;
        const bool right = root.answer == Answer::undecided
                               ? !search.crosses || search.high >= root.low
                               : may_miss || meets(root.touch_low, root.touch_high) ||
                                     (root.after_is_hit && meets(root.low, root.high));
        if (!right) contradicts(fmt::format("the first root is at {}", search.low));
    }

    void contradicts(const std::string& why) {
        ++tally[Count::contradiction];
        ADD_FAILURE() << why;
    }

    static FirstRoot find(roots::RootFinder& with, const roots::Tube& tube) {
        FirstRoot root;
        with.find({&tube, 1}, {&root, 1});
        return root;
    }
    static Ray middle(const roots::Tube& tube) { return {tube.anchor, tube.direction}; }

    catalogue::Used scene;
    formula::EnclosurePrograms programs;
    ThinRays rays;
    roots::RootFinder finder, patient_finder;
    int open_answers = 0, open_answers_a_cause = 1;
    Tally tally;
    static inline Tally total;
};

TEST_P(CertifiedRays, AreAsBallsSay) {
    const roots::Truth truth = roots::certify(scene.scene, scene.at, side, side);
    const auto counts = truth.counts();
    const auto open =
        counts[std::size_t(Answer::touching)] + counts[std::size_t(Answer::undecided)];
    open_answers_a_cause = 1 + int(open) / causes_a_scene;
    const roots::Tubes tubes(scene.at, side, side);
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            SCOPED_TRACE(fmt::format("column {} row {}", column, row));
            const roots::Tube tube = tubes.at(column, row);
            if (tube.near <= tube.far) check(tube, truth.at(column, row));
        }
    }
    tally.print(GetParam());
    total.add(tally);
    for (std::size_t k = 0; k < titles.size(); ++k) RecordProperty(titles[k], tally.counts[k]);
    EXPECT_EQ(tally[Count::contradiction], 0);
    // Not all rays pass by the bounds, and Arb can say something of most.
    EXPECT_GT(tally[Count::proven], side * side / 4);
    // In powers the terms of T_22 cancel, and balls of pieces are as wide as intervals.
    EXPECT_LE(tally[Count::open], side * side / (GetParam() == "chmutov_22_power" ? 10 : 100));
}

INSTANTIATE_TEST_SUITE_P(Balls, CertifiedRays, testing::ValuesIn(every_scene()),
                         [](const auto& scene) { return scene.param; });

} // namespace
} // namespace isomotion::roots_arb::roots_arb_test
