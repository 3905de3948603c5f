// What the posters show is the first root along each ray: the field, sampled densely in double on
// the CPU, says where signs change. No proof, but an independent look at every pixel.
#include <algorithm>

#include "gallery/animations.h"
#include "gallery/segment.h"
#include "render/drawing.h"
#include "scene/surfaces.h"

namespace isomotion::render::hits_test {
namespace {

class GalleryHits : public EveryAnimation {
protected:
    std::unique_ptr<gpu::Context> context = gpu::Context::create();
};
ISOMOTION_ON_EVERY_ANIMATION(GalleryHits);

constexpr int side = 48;

// F at `count` places from `begin` to `end` of a ray.
std::vector<double> samples(const scene::Scene& scene, const formula::Bindings<double>& bindings,
                            const Segment& s, double begin, double end, std::size_t count) {
    std::array<std::vector<double>, 3> points;
    for (int k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < count; ++i) {
            const double t = begin + (end - begin) * double(i) / double(count - 1);
            points[std::size_t(k)].push_back(s.anchor[k] + t * s.direction[k]);
        }
    }
    std::vector<double> values(count);
    const std::array<std::span<const double>, 3> inputs{points[0], points[1], points[2]};
    const std::array<std::span<double>, 1> outputs{values};
    formula::Evaluator<double>(scene.surfaces[0].field->value).points(bindings, inputs, outputs);
    return values;
}

bool changes_sign(std::span<const double> values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *least <= 0 && *most >= 0;
}

TEST_P(GalleryHits, AreTheFirstRootsThatDenseSamplingFinds) {
    for (const std::string& name : animations_of(GetParam())) {
        SCOPED_TRACE(name);
        // Only the first of several surfaces is drawn; effects/surfaces_test.cpp asks of all.
        const scene::Scene all = scene::load(name, {"look=none", "output.size=[48,48]"});
        scene::Scene scene = scene::alone({all, 0});
        scene.sections.clear(); // roots/cut_rays_test.cpp asks of what they leave
        const int frame = scene.output.poster;
        const scene::SceneAt now = scene::at_frame(scene, frame);
        const Picture picture = draw(*context, scene, frame);
        const auto bindings = formula::convert<double>(now.surfaces[0].bindings);
        const scene::Rays rays = scene::rays(now, side, side);
        const auto channel = [&](const char* of, std::size_t k) {
            return double(picture.frame.find(of)->samples[k]);
        };
        // Roots are told apart at this distance along a ray.
        const double close = now.surfaces[0].bounds.radius / 1000;
        int checked = 0, false_hits = 0, missed = 0;
        for (int row = 0; row < side; ++row) {
            for (int column = 0; column < side; ++column) {
                const auto k = std::size_t(row * side + column);
                const Segment s = segment(now, rays, side, column, row);
                if (!(s.near < s.far)) continue;
                ++checked;
                const auto verdict = Verdict(int(channel("verdict", k)));
                double end = s.far;
                if (verdict == Verdict::hit || verdict == Verdict::zero_gradient) {
                    const glm::dvec3 p(channel("P.X", k), channel("P.Y", k), channel("P.Z", k));
                    const double t =
                        glm::dot(now.surfaces[0].placement.to_local(p) - s.anchor, s.direction);
                    if (!changes_sign(samples(scene, bindings, s, t - close, t + close, 33))) {
                        ++false_hits;
                    }
                    end = t - close;
                }
                if (end > s.near && changes_sign(samples(scene, bindings, s, s.near, end, 768))) {
                    ++missed;
                }
            }
        }
        EXPECT_GT(checked, side * side / 12);
        std::printf("%-28s %5d rays, %3d hits without a root, %3d roots passed over\n",
                    name.c_str(), checked, false_hits, missed);
        EXPECT_LE(false_hits, checked / 200);
        EXPECT_LE(missed, checked / 200);
    }
}

} // namespace
} // namespace isomotion::render::hits_test
