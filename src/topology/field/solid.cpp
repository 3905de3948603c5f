#include "topology/field/solid.h"

#include "scene/scene_at.h"

namespace isomotion::topology {
namespace {

constexpr int per_face = 64; // intervals in each direction

// `face` 0 to 5; u and v from -1 to 1. The sphere is the cube, blown up.
glm::dvec3 point_on(const scene::BoundsAt& bounds, int face, double u, double v) {
    const int axis = face / 2;
    glm::dvec3 p;
    p[axis] = face % 2 ? 1 : -1;
    p[(axis + 1) % 3] = u;
    p[(axis + 2) % 3] = v;
    if (bounds.shape == scene::Bounds::Shape::sphere)
        return bounds.centre + bounds.radius * glm::normalize(p);
    return 0.5 * (bounds.min + bounds.max) + 0.5 * p * (bounds.max - bounds.min);
}

} // namespace

Side solid_side(const scene::Scene& scene) {
    const scene::SceneAt first = scene::at(scene, scene.timeline.values(1));
    const auto bindings = formula::convert<double>(first.bindings);
    formula::FieldEvaluator<double> field(*scene.surface.field);
    bool touches_negative = false, touches_positive = false;
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i <= per_face; ++i) {
            for (int j = 0; j <= per_face; ++j) {
                const glm::dvec3 p =
                    point_on(first.bounds, face, 2.0 * i / per_face - 1, 2.0 * j / per_face - 1);
                const double f = field.value(bindings, {p.x, p.y, p.z});
                touches_negative |= f < 0;
                touches_positive |= f > 0;
            }
        }
    }
    return touches_negative && !touches_positive ? Side::positive : Side::negative;
}

} // namespace isomotion::topology
