// Cubics within beams, against certified truth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "accuracy/compare.h"
#include "render/drawing.h"
#include "scene/reading/load.h"

namespace isomotion::accuracy {
namespace {

class HermiteOfCatalogue : public render::Drawing {};
ISOMOTION_ON_EVERY_BACKEND(HermiteOfCatalogue);

// The most certain wrong pixels; superquadrics with m < 1 have cusps that no cubic follows.
struct Known {
    const char* name;
    int wrong = 0;
};

TEST_P(HermiteOfCatalogue, NoCertainPixelIsWrong) {
    for (const Known& known :
         {Known{"torus"}, Known{"cayley"}, Known{"ding_dong"}, Known{"barth_sextic"},
          Known{"blobby75"}, Known{"chmutov_8"}, Known{"goursat"}, Known{"heart"}, Known{"kummer"},
          Known{"tangle"}, Known{"wyvill_soft_objects"}, Known{"superquadric", 36}}) {
        SCOPED_TRACE(known.name);
        const scene::Scene scene = scene::load(
            known.name, {"look=none", "output.size=[64,64]", "isolation.method=\"hermite\""});
        const int frame = scene.output.poster;
        const scene::SceneAt now = scene::at_frame(scene, frame);
        const render::Picture picture = render::draw(*context, scene, frame);
        const Errors errors = compare(now, picture.frame, roots::certify(scene, now, 64, 64));
        EXPECT_LE(errors.wrong(), known.wrong);
        EXPECT_EQ(errors.nan, 0);
        EXPECT_EQ(errors.step_limit, 0);
        EXPECT_GT(render::count(picture, render::Verdict::hit), 300);
    }
}

} // namespace
} // namespace isomotion::accuracy
