// What sections leave of a ball, against its closed form along every ray.
#include <algorithm>
#include <cmath>
#include <random>

#include "roots/cut_rays.h"
#include "view.h"

namespace isomotion::roots::cut_rays_test {
namespace {

// All places on the surface of what sections leave of the unit ball, along the middle of a tube:
// roots of F outside of all sections, and caps.
std::vector<double> surface_of_rest(const scene::SceneAt& now, const Tube& tube) {
    const auto at = [&](double t) { return tube.anchor + t * tube.direction; };
    const auto is_left = [&](double t, std::size_t but) {
        for (std::size_t k = 0; k < now.sections.size(); ++k) {
            if (k != but && now.sections[k].value(at(t)) > 0) return false;
        }
        return true;
    };
    std::vector<double> places;
    for (const double t : on_sphere(tube, 1)) {
        if (is_left(t, now.sections.size())) places.push_back(t);
    }
    for (std::size_t k = 0; k < now.sections.size(); ++k) {
        const scene::SectionAt& section = now.sections[k];
        std::vector<double> crossed;
        if (section.is_ball) {
            Tube moved = tube;
            moved.anchor -= section.where;
            crossed = on_sphere(moved, section.reach);
        } else {
            crossed = {-section.value(tube.anchor) / glm::dot(section.where, tube.direction)};
        }
        for (const double t : crossed) {
            if (glm::length(at(t)) < 1 && is_left(t, k)) places.push_back(t);
        }
    }
    std::ranges::sort(places);
    return places;
}

struct Tally {
    int hits = 0, caps = 0, misses = 0, uncertain = 0;
};

Tally check(const std::string& sections, const std::string& camera, int side = 32) {
    SCOPED_TRACE(sections + camera);
    const scene::Scene scene = scene_of(
        "[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\nbounds = { sphere = 1.5 }\n[camera]\n" +
        camera + "\n" + sections);
    const scene::SceneAt now = scene::at_frame(scene, 1);
    const Tubes all(now, side, side);
    std::vector<Tube> tubes;
    for (int pixel = 0; pixel < side * side; ++pixel)
        tubes.push_back(all.at(pixel % side, pixel / side));
    const formula::EnclosurePrograms field = formula::enclosure_programs(*scene.surfaces[0].field);
    RootFinder finder(field, now.surfaces[0]);
    std::vector<FirstRoot> roots(tubes.size());
    find_first(finder, Sections(now), tubes, roots);
    Tally tally;
    for (std::size_t k = 0; k < tubes.size(); ++k) {
        if (!(tubes[k].near <= tubes[k].far)) continue;
        // Closed forms in double and the floats of sections are so far apart.
        EXPECT_TRUE(holds(roots[k], tubes[k], surface_of_rest(now, tubes[k]), 1e-5))
            << "pixel " << k;
        if (roots[k].cap >= 0) {
            const double t = 0.5 * (double(roots[k].low) + double(roots[k].high));
            const glm::dvec3 place = tubes[k].anchor + t * tubes[k].direction;
            EXPECT_NEAR(now.sections[std::size_t(roots[k].cap)].value(place), 0, 1e-4);
            ++tally.caps;
        }
        ++(roots[k].answer == Answer::hit    ? tally.hits
           : roots[k].answer == Answer::miss ? tally.misses
                                             : tally.uncertain);
    }
    return tally;
}

std::string half_space(const glm::dvec3& normal, double offset) {
    return fmt::format("[[sections]]\nnormal = [{}, {}, {}]\noffset = {}\n", normal.x, normal.y,
                       normal.z, offset);
}

std::string ball(const glm::dvec3& centre, double radius) {
    return fmt::format("[[sections]]\nsphere = {}\ncentre = [{}, {}, {}]\n", radius, centre.x,
                       centre.y, centre.z);
}

TEST(CutRays, OfAHalfBallFromEverywhere) {
    const char* cameras[] = {from_aside, "position = [0, 0, 3]\nfov = 60",
                             "position = [2e4, 1e4, -3e4]\nfov = 0.004",
                             "position = [0, 0, 4]\nprojection = 'orthographic'\nheight = 2.5",
                             // within the ball, and in what is taken away of it
                             "position = [-0.3, 0.1, 0.2]\ntarget = [1, 0, 0]\nfov = 80",
                             "position = [0.4, 0.1, 0.2]\ntarget = [-1, 0, 0]\nfov = 80"};
    for (const char* camera : cameras) {
        const Tally tally = check(half_space({1, 0.1, 0.2}, 0.1), camera);
        EXPECT_GT(tally.hits, 150) << camera;
        EXPECT_LT(tally.uncertain, 30) << camera;
    }
    EXPECT_GT(check(half_space({1, 0, 0}, 0), cameras[0]).caps, 100);
    EXPECT_GT(check(half_space({0.2, 0, 1}, 0.3), cameras[1]).caps, 80);
}

TEST(CutRays, OfAllAndOfNone) {
    EXPECT_EQ(check(half_space({1, 0, 0}, -3), from_aside).hits, 0);
    const Tally none = check(half_space({1, 0, 0}, 3) + ball({0, 0, 9}, 1), from_aside);
    EXPECT_EQ(none.caps, 0);
    EXPECT_GT(none.hits, 300);
    EXPECT_EQ(check(ball({0, 0, 0}, 1.1), from_aside).hits, 0);
    // A ball of no size takes nothing away.
    EXPECT_EQ(check(ball({1, 0, 0}, 0), from_aside).caps, 0);
}

// A section that coincides with the surface: whatever is told must hold.
TEST(CutRays, OfABallWithinItself) {
    const Tally tally = check(ball({0, 0, 0}, 1), from_aside);
    EXPECT_EQ(tally.hits, 0);
}

TEST(CutRays, OfHalfSpacesAndBallsAtRandom) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    const auto number = [&](double least, double most) {
        return std::uniform_real_distribution(least, most)(random);
    };
    const auto place = [&](double size) {
        return glm::dvec3(number(-size, size), number(-size, size), number(-size, size));
    };
    int hits = 0, caps = 0, uncertain = 0;
    for (int k = 0; k < 30; ++k) {
        std::string sections;
        for (int n = int(number(1, 5)); n > 0; --n) {
            sections += number(0, 1) < 0.5 ? half_space(place(1), number(-0.1, 0.7))
                                           : ball(place(1.2), number(0.1, 0.8));
        }
        const glm::dvec3 eye = place(3);
        const Tally tally = check(
            sections, fmt::format("position = [{}, {}, {}]\nfov = 50", eye.x, eye.y, eye.z), 16);
        hits += tally.hits;
        caps += tally.caps;
        uncertain += tally.uncertain;
    }
    EXPECT_GT(hits, 500);
    EXPECT_GT(caps, 100);
    EXPECT_LT(uncertain, hits / 10);
}

} // namespace
} // namespace isomotion::roots::cut_rays_test
