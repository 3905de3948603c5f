// [[sections]] and [material.contours], as they are read and what they are at a time.
#include <random>

#include "scene/cut.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

class SectionsOfScenes : public Scenes {
protected:
    void expect(std::initializer_list<Mistake> mistakes) const {
        for (const auto& [text, message] : mistakes) EXPECT_EQ(mistake(text), message) << text;
    }
};

TEST_F(SectionsOfScenes, AreWhatTheyAreAtATime) {
    const Scene scene =
        loaded(ball_and("[[sections]]\nnormal = [0, 3, 4]\npoint = [1, 5, 0]\noffset = \"t\"\n"
                        "[[sections]]\nsphere = \"1 + t\"\ncentre = [1, 2, \"3*t\"]\n"));
    const SceneAt now = at_time(scene, 2);
    ASSERT_EQ(now.sections.size(), 2u);
    EXPECT_FALSE(now.sections[0].is_ball);
    EXPECT_NEAR(glm::distance(now.sections[0].where, glm::dvec3(0, 0.6, 0.8)), 0, 1e-12);
    EXPECT_NEAR(now.sections[0].reach, 3 + 2, 1e-12);
    EXPECT_EQ(now.sections[1], (SectionAt{true, {1, 2, 6}, 3}));
}

TEST_F(SectionsOfScenes, MoveWithTheScenesCoordinates) {
    const Scene scene = loaded(
        ball_with(7, "bounds = { sphere = 1.5 }\n"
                     "transform = { translate = [1, 2, 3], rotate = [20, 30, 50], scale = 4 }\n") +
        "\n[[sections]]\nnormal = [1, 2, 0]\noffset = 2\n[[sections]]\nsphere = 2\ncentre = [3, 1, "
        "0]\n");
    const SceneAt world = at_time(scene, 0), local = in_formula_coordinates(world);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-2, 2);
    for (int k = 0; k < 100; ++k) {
        const glm::dvec3 p(number(random), number(random), number(random));
        for (std::size_t s = 0; s < 2; ++s) {
            EXPECT_NEAR(world.sections[s].value(world.surfaces[0].placement.to_world(p)),
                        4 * local.sections[s].value(p), 1e-12);
        }
    }
}

TEST_F(SectionsOfScenes, TellTheirMistakes) {
    expect({
        {ball_and("[[sections]]\noffset = 1"),
         "scene.toml:15: sections[0]: needs one of normal = [x, y, z], which points to the "
         "half-space that is taken away, and sphere = radius of a ball that is"},
        {ball_and("[[sections]]\nnormal = [1, 0, 0]\nsphere = 1"),
         "scene.toml:15: sections[0]: needs one of normal = [x, y, z], which points to the "
         "half-space that is taken away, and sphere = radius of a ball that is"},
        {ball_and("[[sections]]\nsphere = 1\noffset = 2"),
         "scene.toml:17: sections[0].offset: is of a half-space, which has a normal; of a ball "
         "give centre = [x, y, z]"},
        {ball_and("[[sections]]\nnormal = [1, 0, 0]\ncentre = [0, 0, 0]"),
         "scene.toml:17: sections[0].centre: is of a ball; of a half-space give point = [x, y, z] "
         "on its plane"},
        {ball_and("[[sections]]\nnormal = [1, 0, 0]\nofset = 2"),
         "scene.toml:17: sections[0].ofset: unknown key; did you mean 'offset'?"},
        {ball_and("[sections]\nnormal = [1, 0, 0]"),
         "scene.toml:15: sections: must be written as [[sections]], one such table a section"},
        {ball_and("[isolation]\ncertify = true\n[[sections]]\nnormal = [1, 0, 0]"),
         "scene.toml:17: isolation.certify: the GPU's proofs know no sections; leave one of the "
         "two "
         "out (audits and `accuracy` know them)"},
    });
    std::string nine;
    for (int k = 0; k < 9; ++k) nine += "[[sections]]\nsphere = 1\n";
    EXPECT_EQ(mistake(ball_and(nine)), "scene.toml:15: sections: at most 8");
    // At a time.
    EXPECT_THAT(mistake(ball_and("[[sections]]\nnormal = [\"0*t\", 0, 0]")),
                testing::HasSubstr("sections[0].normal.x at t = 0: the normal has length 0"));
    EXPECT_THAT(mistake(ball_and("[[sections]]\nsphere = -1")),
                testing::HasSubstr("sections[0].sphere at t = 0: must be 0 or above, not"));
}

TEST_F(SectionsOfScenes, ContoursTellTheirMistakes) {
    const auto contours = [](const char* keys) {
        return ball_and(std::string("[material.contours]\n") + keys);
    };
    expect({
        {contours("every = 1"),
         "scene.toml:15: material.contours.value: is missing; give an expression of x, y, z, t and "
         "the surface's parameters"},
        {contours("value = \"z\""), "scene.toml:15: material.contours.every: is missing; give how "
                                    "far apart in value the lines "
                                    "are, as 0.1"},
    });
    EXPECT_THAT(mistake(contours("value = \"2*nz\"\nevery = 1")),
                testing::StartsWith("scene.toml:16: material.contours.value: lines are of a number "
                                    "of the place, of x, y, z, t and parameters; 'nz' is none"));
    EXPECT_THAT(mistake(contours("value = \"q\"\nevery = 1")),
                testing::HasSubstr("material.contours.value: unknown name 'q'"));
    EXPECT_THAT(mistake(contours("value = \"z\"\nevery = \"t\"")),
                testing::HasSubstr("material.contours.every at t = 0"));
    EXPECT_THAT(mistake(contours("value = \"z\"\nevery = 1\nwidht = 2")),
                testing::HasSubstr("did you mean 'width'?"));
}

// Every point of lines drawn at random is either in a part or in what some section takes away.
TEST(PartsLeft, AreAllThatNoSectionTakesAway) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    int parts_seen = 0;
    for (int k = 0; k < 300; ++k) {
        std::vector<SectionAt> sections;
        for (int n = 1 + k % 4; n > 0; --n) {
            const bool is_ball = number(random) > -0.3;
            sections.push_back({is_ball, is_ball ? vector() : glm::normalize(vector()),
                                is_ball ? 0.5 + 0.4 * number(random) : 0.8 * number(random)});
        }
        const glm::dvec3 anchor = 0.3 * vector(), direction = glm::normalize(vector());
        const auto parts = parts_left(sections, anchor, direction, -2, 1.5);
        parts_seen += int(parts.size());
        for (double t = -1.9995; t < 1.5; t += 0.01) {
            const glm::dvec3 p = anchor + t * direction;
            bool is_taken = false, is_near = false;
            for (const SectionAt& section : sections) {
                is_taken |= section.value(p) > 0;
                is_near |= std::abs(section.value(p)) < 1e-9;
            }
            bool is_left = false;
            for (const PartLeft& part : parts) is_left |= part.begin <= t && t <= part.end;
            if (!is_near) {
                ASSERT_EQ(is_left, !is_taken) << t;
            }
        }
        for (const PartLeft& part : parts) {
            ASSERT_LT(part.begin, part.end);
            ASSERT_EQ(part.begin_cut.has_value(), part.begin > -2);
            ASSERT_EQ(part.end_cut.has_value(), part.end < 1.5);
            for (const auto& [t, cut] :
                 {std::pair{part.begin, part.begin_cut}, {part.end, part.end_cut}}) {
                if (cut) {
                    ASSERT_NEAR(sections[std::size_t(*cut)].value(anchor + t * direction), 0, 1e-9);
                }
            }
        }
    }
    EXPECT_GT(parts_seen, 200);
}

} // namespace
} // namespace isomotion::scene
