// Nodes whose places are known exactly.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "nodes/census.h"

namespace isomotion {
namespace {

using std::numbers::phi;
using Points = std::vector<glm::dvec3>;

// Every place is found, once, and nothing else is.
void expect_nodes(const Census& census, const Points& places) {
    EXPECT_EQ(census.nodes.size(), places.size());
    Points missed;
    for (const glm::dvec3& place : places) {
        const double slack = 1e-8 * (1 + glm::length(place));
        if (std::count_if(census.nodes.begin(), census.nodes.end(), [&](const SingularPoint& node) {
                return glm::distance(node.position(), place) < slack;
            }) != 1) {
            missed.push_back(place);
        }
    }
    EXPECT_TRUE(missed.empty()) << fmt::format("{} places without their node, as ({}, {}, {})",
                                               missed.size(), missed[0].x, missed[0].y,
                                               missed[0].z);
}

std::ptrdiff_t solitary(const Census& census) {
    return std::count_if(census.nodes.begin(), census.nodes.end(),
                         [](const SingularPoint& node) { return node.solitary(); });
}

// T_n(x) + T_n(y) + T_n(z) + c: the critical points of T_n are cos(k pi/n), 0 < k < n, where it is
// 1 for even k and -1 for odd; a node is three of them with sum -c.
struct Chmutov {
    int degree, level, nodes;
};
void PrintTo(const Chmutov& c, std::ostream* to) { *to << c.degree << " at " << c.level; }
std::string chmutov_name(const testing::TestParamInfo<Chmutov>& info) {
    const auto [degree, level, nodes] = info.param;
    return fmt::format("degree_{}_at_{}{}", degree, level < 0 ? "minus" : "", std::abs(level));
}
class ChmutovNodes : public testing::TestWithParam<Chmutov> {};

TEST_P(ChmutovNodes, AreTriplesOfCriticalPoints) {
    const auto [n, level, count] = GetParam();
    Points places;
    const auto point = [n = n](int k) { return std::cos(k * std::numbers::pi / n); };
    const auto value = [](int k) { return k % 2 == 0 ? 1 : -1; };
    for (int i = 1; i < n; ++i) {
        for (int j = 1; j < n; ++j) {
            for (int k = 1; k < n; ++k) {
                if (value(i) + value(j) + value(k) == -level) {
                    places.push_back({point(i), point(j), point(k)});
                }
            }
        }
    }
    ASSERT_EQ(places.size(), std::size_t(count));
    const Census census =
        census_of(fmt::format("use = 'chmutov_{}'", n), {fmt::format("c={}", level)});
    SCOPED_TRACE(describe(census));
    EXPECT_TRUE(census.settled);
    expect_nodes(census, places);
    // Three minima or three maxima are a point; else it is a cone.
    EXPECT_EQ(solitary(census), std::abs(level) == 3 ? count : 0);
    EXPECT_TRUE(census.degenerate.empty());
}

INSTANTIATE_TEST_SUITE_P(Levels, ChmutovNodes,
                         testing::Values(Chmutov{6, 1, 3 * 3 * 3 * 2}, Chmutov{6, -3, 2 * 2 * 2},
                                         Chmutov{7, 1, 81}, Chmutov{7, -1, 81}, Chmutov{8, 1, 144},
                                         Chmutov{8, -1, 108}, Chmutov{8, 3, 64}, Chmutov{8, -3, 27},
                                         Chmutov{9, 1, 192}, Chmutov{12, 1, 540}),
                         chmutov_name);

TEST(ChmutovOctic, HasItsNodesAtTheDefaultOfItsNodalForm) {
    const Census census = census_of("use = 'chmutov_8_nodal'");
    EXPECT_EQ(census.nodes.size(), 144u) << describe(census);
}

// The vertices of the 600-cell: 24 of a 24-cell, and the odd permutations of
// (+-phi, +-1, +-1/phi, 0)/2. (The even ones make the mirror image, of which S is no invariant.)
std::vector<glm::dvec4> vertices_of_600_cell() {
    std::vector<glm::dvec4> vertices;
    for (int axis = 0; axis < 4; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec4 v(0);
            v[axis] = sign;
            vertices.push_back(v);
        }
    }
    const auto sign = [](int signs, int bit) { return signs >> bit & 1 ? -1.0 : 1.0; };
    for (int signs = 0; signs < 16; ++signs) {
        vertices.push_back(
            0.5 * glm::dvec4(sign(signs, 0), sign(signs, 1), sign(signs, 2), sign(signs, 3)));
    }
    std::array<int, 4> order{0, 1, 2, 3};
    do {
        int inversions = 0;
        for (std::size_t a = 0; a < 4; ++a) {
            for (std::size_t b = a + 1; b < 4; ++b) inversions += order[a] > order[b];
        }
        if (inversions % 2 == 0) continue;
        for (int signs = 0; signs < 8; ++signs) {
            glm::dvec4 v(0);
            v[order[0]] = 0.5 * phi * sign(signs, 0);
            v[order[1]] = 0.5 * sign(signs, 1);
            v[order[2]] = 0.5 / phi * sign(signs, 2);
            vertices.push_back(v);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return vertices;
}

// The finite points below the centres of the faces with `corners` vertices, which are any that are
// all neighbours of each other.
Points centres(int corners) {
    const std::vector<glm::dvec4> vertices = vertices_of_600_cell();
    Points points;
    const auto extend = [&](const auto& self, std::vector<std::size_t> face) -> void {
        if (int(face.size()) == corners) {
            glm::dvec4 sum(0);
            for (const std::size_t v : face) sum += vertices[v];
            if (sum.w > 1e-9) points.push_back(glm::dvec3(sum) / sum.w);
            return;
        }
        for (std::size_t next = face.empty() ? 0 : face.back() + 1; next < vertices.size();
             ++next) {
            const bool neighbours = std::all_of(face.begin(), face.end(), [&](std::size_t v) {
                return std::abs(glm::dot(vertices[v], vertices[next]) - phi / 2) < 1e-9;
            });
            if (!neighbours) continue;
            face.push_back(next);
            self(self, face);
            face.pop_back();
        }
    };
    extend(extend, {});
    return points;
}

// Sarti's pencil S - lam Q is that of the 600-cell's invariants of degree 12. Its members with
// nodes have them at the vertices and at the centres of edges, triangles and cells, each pair of
// opposite ones being one point.
struct Sarti {
    const char* places;
    int corners;
    const char* lam;
    int nodes; // finite ones of 60, 360, 600, 300
    bool solitary;
};
void PrintTo(const Sarti& s, std::ostream* to) { *to << "lam = " << s.lam; }
std::string sarti_name(const testing::TestParamInfo<Sarti>& info) { return info.param.places; }
class SartiNodes : public testing::TestWithParam<Sarti> {};

TEST_P(SartiNodes, AreCentresOfThe600Cell) {
    const Sarti expected = GetParam();
    const Points places = centres(expected.corners);
    ASSERT_EQ(places.size(), std::size_t(expected.nodes));
    const Census census = census_of("use = 'sarti_dodecic'", {std::string("lam=") + expected.lam});
    SCOPED_TRACE(describe(census));
    EXPECT_TRUE(census.settled);
    expect_nodes(census, places);
    EXPECT_EQ(solitary(census), expected.solitary ? expected.nodes : 0);
    EXPECT_TRUE(census.degenerate.empty());
}

INSTANTIATE_TEST_SUITE_P(Pencil, SartiNodes,
                         testing::Values(Sarti{"vertices", 1, "0", 45, true},
                                         Sarti{"edges", 2, "2/25", 324, false},
                                         Sarti{"triangles", 3, "22/243", 560, false},
                                         Sarti{"cells", 4, "3/32", 270, true}),
                         sarti_name);

// 4 A^3 + 27 B^2 is singular along A = B = 0, and nowhere else but at its nodes.
TEST(Hunt, DegeneratePointsAreItsEdge) {
    const Census census = census_of("use = 'hunt'");
    EXPECT_GT(census.degenerate.size(), 100u);
    for (const SingularPoint& point : census.degenerate) {
        const glm::dvec3 p = point.position(), square = p * p;
        EXPECT_EQ(point.rank, 1);
        EXPECT_NEAR(square.x + square.y + square.z, 13, 1e-4);
        EXPECT_NEAR(3 * square.x + square.y - 4 * square.z, 12, 1e-4);
    }
}

} // namespace
} // namespace isomotion
