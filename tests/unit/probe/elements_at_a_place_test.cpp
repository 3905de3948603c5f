#include "probe/elements_at_a_place.h"

#include <fmt/format.h>

#include "unit/scene/testing.h"

namespace isomotion::probe {
namespace {

using namespace scene;

std::string scene_of_balls(const std::string& count, const std::string& x,
                           const std::string& term = "max(0, 1 - ((x-cx)^2 + (y-cy)^2 + "
                                                     "(z-cz)^2)/0.01)^3") {
    return fmt::format("[time]\nfps = 4\nframes = 5\n[surface]\nformula = \"sum(p, {}) - 0.5\"\n"
                       "bounds = {{ box = [[-0.5, -0.5, -0.5], [9.5, 9.5, 9.5]] }}\n"
                       "[arrays.p]\ncount = {}\ncx = \"{}\"\ncy = \"floor(i/10) - "
                       "10*floor(i/100)\"\ncz = \"floor(i/100)\"\n",
                       term, count, x);
}

const std::string on_a_lattice = "i - 10*floor(i/10)";

class ElementsAtAPlace : public Scenes {
protected:
    std::optional<double> found(const std::string& text) const {
        return loaded(text).surfaces[0].measured.elements_at_a_place;
    }
};

TEST_F(ElementsAtAPlace, AreOneWhereSupportsAreApart) {
    const auto lattice = found(scene_of_balls("1000", on_a_lattice));
    ASSERT_TRUE(lattice);
    EXPECT_NEAR(*lattice, 1, 1e-9);
}

TEST_F(ElementsAtAPlace, AreAllWhereSupportsMeet) {
    const auto pile = found(
        scene_of_balls("300", "0.001*i", "max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/900)^3"));
    ASSERT_TRUE(pile);
    EXPECT_EQ(*pile, 300);
}

TEST_F(ElementsAtAPlace, AreTheMeanOverFrames) {
    // Ten are at each of ten places at first, and all are apart at the other four frames.
    const auto gathering =
        found(scene_of_balls("100", "(" + on_a_lattice + ")*min(1, floor(t*4))"));
    ASSERT_TRUE(gathering);
    EXPECT_NEAR(*gathering, (10 + 4 * 1) / 5.0, 1e-9);
}

TEST_F(ElementsAtAPlace, AreUnknownOfFewOrManyAndWithoutKernels) {
    EXPECT_TRUE(found(scene_of_balls("65", on_a_lattice)));
    EXPECT_FALSE(found(scene_of_balls("64", on_a_lattice)));
    EXPECT_TRUE(found(scene_of_balls("2000", on_a_lattice)));
    EXPECT_FALSE(found(scene_of_balls("2001", on_a_lattice)));
    EXPECT_FALSE(found(scene_of_balls("100", on_a_lattice, "sin(x*cx + y*cy + z*cz)")));
    EXPECT_FALSE(found("[surface]\nformula = \"x^2 + y^2 + z^2 = 1\"\n"));
}

} // namespace
} // namespace isomotion::probe
