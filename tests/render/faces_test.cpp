// Bounds are closed: roots on their very faces are found, by every method, from either side.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

class Faces : public Drawing {
protected:
    Picture look(const std::string& formula, const std::string& bounds, const std::string& from,
                 scene::Method method, bool beam) {
        return draw(*context,
                    scene_of(fmt::format("[surface]\nformula = \"{}\"\nbounds = {}\n"
                                         "[camera]\nposition = {}\nfov = 36\n"
                                         "[output]\nsize = [61, 47]\n[isolation]\n"
                                         "method = \"{}\"\nbeam = {}\n",
                                         formula, bounds, from, scene::name(method), beam)));
    }
    // `check` is told of every method, with and without beams.
    template<class Check> void by_every_method(const Check& check) {
        for (const auto& entry : scene::method_traits) {
            for (const bool beam : {false, true}) {
                SCOPED_TRACE(fmt::format("{}, beam {}", entry.name, beam));
                check(entry.method, beam);
            }
        }
    }
};
ISOMOTION_ON_EVERY_BACKEND(Faces);

std::int64_t found(const Picture& picture) {
    return count(picture, Verdict::hit) + count(picture, Verdict::zero_gradient);
}

bool is_found(const Picture& picture, std::size_t pixel) {
    const auto verdict = Verdict(int(picture.frame.find("verdict")->samples[pixel]));
    return verdict == Verdict::hit || verdict == Verdict::zero_gradient;
}

std::string eye(double half, const glm::dvec3& way) {
    return fmt::format("[{}, {}, {}]", half * way.x, half * way.y, half * way.z);
}

// A plane that is a face of a box, and one that is not quite: it lies a little inside, so that its
// rays tell what the first must find. The last two faces are no floats.
TEST_P(Faces, OfABoxAreHitLikePlanesJustInside) {
    for (const double half : {1.0, 0.3, 1234.1}) {
        // A frame each: the plane inside and on the face, from where rays enter, where they leave,
        // and slantwise.
        const std::string scene =
            fmt::format(R"toml(
[time]
fps = 1
frames = 6
[surface]
formula = "h - x"
bounds = {{ box = [[-{0}, -{0}, -{0}], [{0}, {0}, {0}]] }}
[parameters]
h = {{ ease = "hold", keys = [[0, {1}], [1, {0}], [2, {1}], [3, {0}], [4, {1}], [5, {0}]] }}
[camera]
position = {{ ease = "hold", keys = [[0, {2}], [2, {3}], [4, {4}]] }}
fov = 36
[output]
size = [61, 47]
)toml",
                        half, 0.999 * half, eye(half, {5, 0.3, 0.2}), eye(half, {-5, 0.3, 0.2}),
                        eye(half, {2.4, 4.1, 1.9}));
        by_every_method([&](scene::Method method, bool beam) {
            const scene::Scene drawn =
                scene_of(scene, {fmt::format("isolation.method=\"{}\"", scene::name(method)),
                                 fmt::format("isolation.beam={}", beam)});
            Renderer renderer(*context, drawn,
                              {drawn.output.width, drawn.output.height, every_channel, {}});
            const auto picture = [&](int frame) {
                return renderer.draw(scene::at_frame(drawn, frame));
            };
            for (int frame = 1; frame < drawn.timeline.frames; frame += 2) {
                SCOPED_TRACE(fmt::format("box of {}, frame {}", half, frame));
                const Picture inside = picture(frame), face = picture(frame + 1);
                EXPECT_GT(found(inside), 150);
                int differ = 0, far = 0;
                for (std::size_t k = 0; k < face.frame.find("verdict")->samples.size(); ++k) {
                    // At the face's rim either may be beside it.
                    differ += is_found(inside, k) != is_found(face, k);
                    if (is_found(face, k)) {
                        far += std::abs(face.frame.find("P.X")->samples[k] - half) > 1e-4 * half;
                    }
                }
                EXPECT_LE(differ, 6);
                EXPECT_EQ(far, 0);
                EXPECT_EQ(count(face, Verdict::step_limit) + count(face, Verdict::nan), 0);
            }
        });
    }
}

// A ball in bounds that end where it does: the picture of a ball in larger ones.
TEST_P(Faces, OfASphereAreHitLikeABallInside) {
    const std::string ball = "x^2 + y^2 + z^2 - 1";
    by_every_method([&](scene::Method method, bool beam) {
        const Picture inside = look(ball, "{ sphere = 1.5 }", "[3, 1, 1.5]", method, beam);
        const Picture face = look(ball, "{ sphere = 1 }", "[3, 1, 1.5]", method, beam);
        EXPECT_GT(found(inside), 500);
        // Chords of less than a step are stepped over, where they begin inside the bounds.
        const std::int64_t silhouette = scene::takes_steps(method) ? 40 : 2;
        EXPECT_NEAR(double(found(face)), double(found(inside)), double(silhouette));
        int far = 0;
        for (std::size_t k = 0; k < face.frame.find("verdict")->samples.size(); ++k) {
            if (!is_found(face, k) || !is_found(inside, k)) continue;
            const double difference =
                face.frame.find("Z")->samples[k] - inside.frame.find("Z")->samples[k];
            far += std::abs(difference) > 1e-2;
        }
        EXPECT_EQ(far, 0);
    });
}

// Roots that F only touches 0 at are on the face, too: of the methods that see any.
TEST_P(Faces, TouchedByF) {
    const std::string bounds = "{ box = [[-1, -1, -1], [1, 1, 1]] }";
    for (const char* from : {"[5, 0.3, 0.2]", "[-5, 0.3, 0.2]"}) {
        for (const bool beam : {false, true}) {
            SCOPED_TRACE(fmt::format("from {}, beam {}", from, beam));
            const Picture plane = look("1 - x", bounds, from, scene::Method::hermite, beam);
            const Picture twice = look("(1 - x)^2", bounds, from, scene::Method::hermite, beam);
            EXPECT_NEAR(double(found(twice)), double(found(plane)), 6);
        }
    }
}

} // namespace
} // namespace isomotion::render
