// Pictures agree with timelines: no view of a quiet span shows more parts than the solid has, and
// what happens at an event is seen where it is.
#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "gallery/segment.h"
#include "render/renderer.h"
#include "topology/golden.h"
#include "topology/scenes.h"
#include "topology/timeline/steps.h"
#include "topology/timeline/timeline_file.h"

namespace isomotion::topology {
namespace {

constexpr int side = 96;
// So many spans and events of a long timeline, spread over it.
constexpr std::size_t most_spans = 12, most_instants = 12;

// Directions from the middles of a cube's faces and edges and from its corners, all a little off:
// symmetric surfaces hide one part behind another.
std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> all;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                all.push_back(glm::normalize(glm::dvec3(x + 0.11, y + 0.07, z + 0.05)));
            }
        }
    }
    return all;
}

// The bounds just fill the picture: nothing of the surface is outside of it.
void look_from(const glm::dvec3& direction, scene::SceneAt& now) {
    scene::CameraAt& camera = now.camera;
    camera = {};
    camera.target = now.surfaces[0].placement.to_world(now.surfaces[0].bounds.centre);
    const double radius = now.surfaces[0].placement.scale * now.surfaces[0].bounds.radius;
    const double half_angle = glm::radians(camera.fov) / 2;
    camera.position = camera.target + 1.02 * radius / std::sin(half_angle) * direction;
    camera.up = std::abs(direction.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
}

// What a pixel's ray meets first, of the solid: -1 for nothing, else how far from the eye; formula
// coordinates. A ray that enters the bounds inside of the solid, where a wall cuts it, meets it
// there.
struct View {
    int side = 0;
    scene::Rays rays;
    std::vector<double> distance; // by row, the top row first

    double at(int column, int row) const {
        return distance[std::size_t(row) * std::size_t(side) + std::size_t(column)];
    }
    glm::dvec3 eye() const { return rays.origin - rays.axis; }

    // Where a point is in the picture, in pixels from the upper left.
    glm::dvec2 project(const glm::dvec3& p) const {
        const glm::dvec3 s = glm::inverse(glm::dmat3(rays.axis, rays.right, rays.up)) * (p - eye());
        const double u = s.y / s.x, v = s.z / s.x;
        return {(u + 1) / 2 * side, (1 - v) / 2 * side};
    }
};

// Parts of the silhouette, neighbours by sides and corners.
int parts(const View& view) {
    std::vector<bool> seen(view.distance.size(), false);
    int parts = 0;
    for (std::size_t first = 0; first < seen.size(); ++first) {
        if (seen[first] || view.distance[first] < 0) continue;
        ++parts;
        std::vector<std::size_t> stack{first};
        seen[first] = true;
        while (!stack.empty()) {
            const int at = int(stack.back());
            stack.pop_back();
            for (int row = at / view.side - 1; row <= at / view.side + 1; ++row) {
                for (int column = at % view.side - 1; column <= at % view.side + 1; ++column) {
                    if (row < 0 || column < 0 || row >= view.side || column >= view.side) continue;
                    const std::size_t k = std::size_t(row * view.side + column);
                    if (seen[k] || view.distance[k] < 0) continue;
                    seen[k] = true;
                    stack.push_back(k);
                }
            }
        }
    }
    return parts;
}

class Pictures : public testing::TestWithParam<std::string> {
protected:
    Pictures()
        : scene(animated(GetParam()))
        , timeline(read_timeline(golden_file(GetParam())).timeline)
        , steps(steps_of(timeline))
        , sign(solid_side(scene) == Side::negative ? 1 : -1)
        , field(*scene.surfaces[0].field) {}

    View draw(double time, const glm::dvec3& direction, int size = side) {
        scene::SceneAt now = scene::at(scene, time);
        look_from(direction, now);
        auto& renderer = size == side ? coarse : fine;
        if (!renderer) {
            using shader::Channel;
            render::RenderOptions options;
            options.width = options.height = size;
            options.channels = {Channel::position, Channel::verdict};
            renderer = std::make_unique<render::Renderer>(*context, scene, options);
        }
        const render::Picture picture = renderer->draw(now);
        View view{size, scene::rays(now, size, size), {}};
        const auto bindings = formula::convert<double>(now.surfaces[0].bindings);
        const auto channel = [&](const char* name, std::size_t k) {
            return picture.frame.find(name)->samples[k];
        };
        for (int row = 0; row < size; ++row) {
            for (int column = 0; column < size; ++column) {
                const auto k = std::size_t(row * size + column);
                const render::Segment s = render::segment(now, view.rays, size, column, row);
                double met = -1;
                const glm::dvec3 entry = s.anchor + s.near * s.direction;
                const auto verdict = render::Verdict(int(channel("verdict", k)));
                if (s.near < s.far &&
                    sign * field.value(bindings, {entry.x, entry.y, entry.z}) < 0) {
                    met = glm::distance(entry, view.eye());
                } else if (verdict == render::Verdict::hit ||
                           verdict == render::Verdict::zero_gradient) {
                    const glm::dvec3 p(channel("P.X", k), channel("P.Y", k), channel("P.Z", k));
                    met = glm::distance(now.surfaces[0].placement.to_local(p), view.eye());
                }
                view.distance.push_back(met);
            }
        }
        radius = now.surfaces[0].bounds.radius;
        return view;
    }

    // The instants with the most time to their neighbours: what happens there is large enough to be
    // seen.
    std::vector<std::size_t> loneliest_instants() const {
        std::vector<std::size_t> some(steps.instants.size());
        std::iota(some.begin(), some.end(), 0u);
        const auto quiet = [&](std::size_t k) {
            return std::min(width(steps.steps[k].time), width(steps.steps[k + 1].time));
        };
        std::ranges::stable_sort(some, std::ranges::greater{}, quiet);
        if (some.size() > most_instants) some.resize(most_instants);
        return some;
    }

    std::unique_ptr<gpu::Context> context = gpu::Context::create();
    const scene::Scene scene;
    const Timeline timeline;
    const Steps steps;
    const double sign; // times F: negative in the solid
    formula::FieldEvaluator<double> field;
    std::unique_ptr<render::Renderer> coarse, fine;
    double radius = 1; // of the bounds
};

// A part of the solid is one part of the silhouette, or a piece of one. Where pixels make pieces of
// what is thin, more pixels put them together.
TEST_P(Pictures, ShowNoMorePartsThanTheSolidHas) {
    int pictures = 0, finer = 0;
    const std::size_t stride = 1 + steps.steps.size() / most_spans;
    for (std::size_t k = 0; k < steps.steps.size(); k += stride) {
        const Step& step = steps.steps[k];
        if (!step.solid || !(step.time.lo < step.time.hi)) continue;
        const double time = mid(step.time);
        SCOPED_TRACE(fmt::format("at {} s", time));
        int most = 0;
        for (const glm::dvec3& direction : directions()) {
            int found = parts(draw(time, direction));
            ++pictures;
            if (found > step.solid->components) {
                found = parts(draw(time, direction, 4 * side));
                ++finer;
            }
            EXPECT_LE(found, step.solid->components)
                << "from " << direction.x << ' ' << direction.y << ' ' << direction.z;
            most = std::max(most, found);
        }
        // And some view tells several parts from one, and one from nothing.
        EXPECT_GE(most, std::min(step.solid->components, 2));
    }
    fmt::print("{} pictures, {} of them drawn finer\n", pictures, finer);
    EXPECT_GT(pictures, 0);
}

// The pictures before and after, taken at a part of the time to the event's neighbours, differ at
// the event's pixel in some view in which nothing is before it: there is something in one of them
// and nothing in the other, or it is elsewhere. Most events are seen from somewhere.
TEST_P(Pictures, DifferWhereAnEventIs) {
    constexpr double part = 0.15;
    int seen = 0, hidden = 0;
    for (const std::size_t k : loneliest_instants()) {
        const formula::Interval before = steps.steps[k].time, after = steps.steps[k + 1].time;
        std::vector<std::pair<View, View>> views;
        for (const glm::dvec3& direction : directions()) {
            views.emplace_back(draw(before.hi - part * (before.hi - before.lo), direction),
                               draw(after.lo + part * (after.hi - after.lo), direction));
        }
        for (const std::size_t number : steps.instants[k].events) {
            const Event& event = timeline.events[number];
            SCOPED_TRACE(fmt::format("{} at {} s", name(event.kind), mid(event.time)));
            const glm::dvec3 p(mid(event.where[0]), mid(event.where[1]), mid(event.where[2]));
            int open = 0, differ = 0;
            for (const auto& [first, second] : views) {
                const glm::dvec2 pixel = glm::floor(first.project(p));
                const auto column = int(pixel.x), row = int(pixel.y);
                ASSERT_TRUE(0 <= column && column < side && 0 <= row && row < side);
                const double a = first.at(column, row), b = second.at(column, row);
                const double least = glm::distance(p, first.eye()) - 0.1 * radius;
                if ((a >= 0 && a < least) || (b >= 0 && b < least)) continue;
                ++open;
                differ += (a < 0) != (b < 0) || std::abs(a - b) > 0.05 * radius;
            }
            ++(open > 0 ? seen : hidden);
            if (open > 0) {
                EXPECT_GT(differ, 0) << "of " << open << " views";
            }
        }
    }
    fmt::print("{} events seen, {} hidden\n", seen, hidden);
    EXPECT_GE(seen, hidden);
    EXPECT_EQ(seen + hidden == 0, timeline.events.empty());
}

INSTANTIATE_TEST_SUITE_P(Golden, Pictures, testing::ValuesIn(golden_names()),
                         [](const auto& name) { return name.param; });

} // namespace
} // namespace isomotion::topology
