// Compares the counts of methods with recorded ones: evaluations a ray and wrong pixels of a few
// cheap surfaces with every method. No clock.
//
// ISOMOTION_BLESS=1 build/release/tests/bench/counts_test writes expected_counts.csv anew; look at
// the difference. A method that joins needs this too. Tests blessed alone leave other rows alone.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "methods/contest.h"

namespace isomotion::bench {
namespace {

constexpr const char* table = ISOMOTION_SOURCE_DIR "/tests/bench/expected_counts.csv";
constexpr int size = 128;

// Drivers fuse and reassociate where nothing forbids it, which moves a root by a rounding: a few
// rays take a step more, and a pixel at a silhouette may change sides.
constexpr double evaluations_tolerance = 0.02; // relative
constexpr std::int64_t wrong_tolerance = 2;    // pixels

struct Row {
    std::string refused; // the method can't draw this
    double evaluations_a_ray = 0;
    std::int64_t missed = 0, false_hits = 0, wrong_roots = 0;

    std::int64_t wrong() const { return missed + false_hits + wrong_roots; }
    std::string text() const {
        if (!refused.empty()) return "refused,,,";
        return fmt::format("{:.3f},{},{},{}", evaluations_a_ray, missed, false_hits, wrong_roots);
    }
};

using Key = std::pair<std::string, std::string>; // surface, method

std::map<Key, Row> read_table() {
    std::map<Key, Row> rows;
    std::ifstream file(table);
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.starts_with('#') || line.starts_with("surface,")) continue;
        char surface[64], method[64], evaluations[64];
        long missed = 0, false_hits = 0, wrong_roots = 0;
        const int read = std::sscanf(line.c_str(), "%63[^,],%63[^,],%63[^,],%ld,%ld,%ld", surface,
                                     method, evaluations, &missed, &false_hits, &wrong_roots);
        Row row;
        if (read == 3 && std::string(evaluations) == "refused") {
            row.refused = evaluations;
        } else if (read == 6) {
            row = {{}, std::atof(evaluations), missed, false_hits, wrong_roots};
        } else {
            throw std::runtime_error("expected_counts.csv: '" + line +
                                     "' is no row; bless the table anew");
        }
        rows[{surface, method}] = row;
    }
    return rows;
}

void write_table(const std::map<Key, Row>& rows) {
    std::ofstream file(table);
    file << fmt::format("# Written by ISOMOTION_BLESS=1 build/release/tests/bench/counts_test: {0} "
                        "x {0} pixels, the\n"
                        "# scene's own step. Held to {1:g} of the evaluations either way, and no "
                        "more wrong pixels\n"
                        "# than these and {2} more.\n"
                        "surface,method,evaluations_per_ray,missed,false_hits,wrong_roots\n",
                        size, evaluations_tolerance, wrong_tolerance);
    for (const auto& [key, row] : rows) {
        file << fmt::format("{},{},{}\n", key.first, key.second, row.text());
    }
}

bool blessing() {
    const char* bless = std::getenv("ISOMOTION_BLESS");
    return bless && *bless;
}

class Counts : public testing::TestWithParam<std::string> {};

TEST_P(Counts, AreThoseExpected) {
    const std::string& name = GetParam();
    const auto context = gpu::Context::create();
    const Certified on = certified(surface(name), size, {});
    std::map<Key, Row> expected = read_table();
    for (const scene::MethodTraits& method : scene::method_traits) {
        const Key key(name, method.name);
        SCOPED_TRACE(fmt::format("{} {}", key.first, key.second));
        Row row;
        try {
            const accuracy::Setting setting{method.method,
                                            on.subject.scene.surfaces[0].isolation.step, 1,
                                            on.subject.scene.surfaces[0].isolation.bisections,
                                            on.subject.scene.surfaces[0].isolation.safety};
            const Count counted = count(*context, on, setting);
            const accuracy::Errors& e = counted.errors;
            row = {{}, counted.evaluations_a_ray(), e.missed, e.false_hits, e.wrong_roots};
        } catch (const std::exception& error) {
            row.refused = error.what();
        }
        if (blessing()) {
            expected[key] = row;
            continue;
        }
        if (!expected.contains(key)) {
            ADD_FAILURE() << "has no row in expected_counts.csv; it would be\n  " << row.text();
            continue;
        }
        const Row& before = expected.at(key);
        const std::string difference =
            fmt::format("evaluations a ray, missed, false hits, wrong roots\n  - {}\n  + {}\n  {}",
                        before.text(), row.text(), row.refused);
        EXPECT_EQ(before.refused.empty(), row.refused.empty()) << difference;
        EXPECT_NEAR(row.evaluations_a_ray, before.evaluations_a_ray,
                    evaluations_tolerance * before.evaluations_a_ray)
            << difference;
        EXPECT_LE(row.wrong(), before.wrong() + wrong_tolerance) << difference;
    }
    if (blessing()) write_table(expected);
}

// A method or a surface that went away leaves no row behind.
TEST(CountsTable, HasNoStrangers) {
    for (const auto& [key, row] : read_table()) {
        EXPECT_TRUE(scene::parse_method(key.second)) << key.first << " " << key.second;
    }
}

// Cubics ask for bounds of this one only where they take F for 0 without a change of sign.
TEST(Operations, AreThoseOfASample) {
    const scene::Scene scene = surface("barth_sextic").scene;
    const double of_values = operations(scene, scene::Method::amp_sign);
    EXPECT_GT(of_values, 20);
    EXPECT_EQ(operations(scene, scene::Method::hermite), of_values);
    EXPECT_GT(operations(scene, scene::Method::interval), 2 * of_values);
}

// Surfaces of every kind: nodes, a double line, cancellation, a polynomial of degree 14, none.
INSTANTIATE_TEST_SUITE_P(Bench, Counts,
                         testing::Values("ding_dong", "cayley", "torus", "steiner", "barth_sextic",
                                         "chmutov_14", "blobby", "diamond", "superquadric"),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace isomotion::bench
