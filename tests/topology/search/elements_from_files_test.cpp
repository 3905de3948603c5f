// Elements of files that come, go and change their rows: what jumps is unresolved.
#include "topology/analyse.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

// Three seconds, with this field and an array of two ids.
Timeline timeline_of(const std::string& formula, const std::string& fields,
                     const std::string& table) {
    return analyse(scene_of(fmt::format("[time]\nframes = 31\nfps = 10\n[surface]\nformula = "
                                        "\"{}\"\nbounds = {{ sphere = 8 }}\n[arrays.b]\n"
                                        "file = \"table.csv\"\n{}\n",
                                        formula, fields),
                            table));
}

void expect_jumps(const Timeline& timeline, const std::vector<double>& times) {
    SCOPED_TRACE(described(timeline));
    EXPECT_FALSE(timeline.is_complete());
    ASSERT_EQ(timeline.unresolved.size(), times.size());
    for (std::size_t k = 0; k < times.size(); ++k)
        EXPECT_EQ(timeline.unresolved[k].time, formula::Interval(times[k]));
}

// One element, two from 1 s to 2 s.
const std::string one_two_one = "t,px,id\n0,0,1\n1,0,1\n1,1,2\n2,0,1\n3,0,1\n";

TEST(ElementsFromFiles, AreCountedByASumThatReadsNoField) {
    // A ball of radius 0.7 while there are two, else none.
    for (const auto& [sum, fields] :
         {std::pair("sum(b, 1)", ""), std::pair("sum(b, w)", "w = 1"),
          std::pair("sum(b, w)/4", "w = \"3 + cos(0*t)\""), std::pair("sum(b, u)", "u = \"n/2\""),
          std::pair("sum(b, u + 1)", "u = \"0.2*i*(1 - n/2)\"")}) {
        SCOPED_TRACE(sum);
        const Timeline timeline =
            timeline_of(fmt::format("x^2 + y^2 + z^2 + 1.5 - {}", sum), fields, one_two_one);
        expect_jumps(timeline, {1, 2});
        ASSERT_EQ(timeline.unresolved.size(), 2u);
        EXPECT_EQ(timeline.start, (Betti{0, 0, 0}));
        EXPECT_EQ(timeline.unresolved[0].after, (Betti{1, 0, 0}));
        EXPECT_EQ(timeline.end, (Betti{0, 0, 0}));
    }
}

TEST(ElementsFromFiles, AreCountedWhereATrackIsTheClock) {
    // All but the count goes through r.
    const scene::Scene scene = scene_of(
        "[time]\nframes = 31\nfps = 10\n[surface]\nformula = \"x^2 + y^2 + z^2 + 1.5 + r - "
        "sum(b, 1)\"\nbounds = { sphere = 8 }\n[parameters]\nr = \"0.1*sin(t)\"\n[arrays.b]\n"
        "file = \"table.csv\"\n",
        one_two_one);
    expect_jumps(analyse(scene), {1, 2});
}

TEST(ElementsFromFiles, JumpWithTheirRowsWhereRowsAreRead) {
    // Two balls that rest; from 1 s to 2 s they have each other's rows, and are one or three apart.
    const std::string rows =
        "t,px,id\n0,-1,1\n0,1,2\n1,1,2\n1,-1,1\n2,-1,1\n2,1,2\n3,-1,1\n3,1,2\n";
    const std::string balls = "0.5 - sum(b, exp(-3*((x-u)^2 + y^2 + z^2)))";
    for (const char* field : {"u = \"0.5*px + 0.9*(i - 0.5)\"",
                              "u = \"0.9*px + 4*(random(i, 1) - random(1 - i, 1))\""}) {
        SCOPED_TRACE(field);
        expect_jumps(timeline_of(balls, field, rows), {1, 2});
    }
    // By their own columns they rest.
    const Timeline still = timeline_of(balls, "u = \"0.9*px\"", rows);
    EXPECT_TRUE(still.is_complete()) << described(still);
    EXPECT_EQ(still.start, (Betti{2, 0, 0}));
}

} // namespace
} // namespace isomotion::topology
