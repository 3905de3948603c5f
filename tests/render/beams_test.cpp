// Beams leave out no part of a ray that has a root: pictures with and without them agree, whatever
// the camera.
#include "render/drawing.h"

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/uniform_blocks.h"
#include "scene/data_folder.h"
#include "scene/ray_rounding.h"
#include "scene/reading/load.h"
#include "thorough.h"

namespace isomotion::render {
namespace {

// As amp-sign's steps depend on where a ray begins, and a beam moves that, a picture may find roots
// that another steps over; so each is compared with two finer ones.
struct Comparison {
    int hits = 0;  // without beams
    int lost = 0;  // of them, not even at the finest step with beams
    int later = 0; // of them, a root behind by more than steps explain
};

// A scene's renderers: without beams, and with them at three steps. They compile once, whatever the
// camera.
class Views {
public:
    Views(gpu::Context& context, const scene::Scene& scene)
        : context_(context)
        , scene_(scene) {}

    Picture plain(const scene::SceneAt& now, const scene::Aim& aim) {
        return draw(plain_, false, 1, now, aim);
    }
    Picture beams(const scene::SceneAt& now, const scene::Aim& aim, std::size_t level) {
        constexpr double finer[] = {1, 5, 23};
        return draw(beams_[level], true, finer[level], now, aim);
    }

private:
    Picture draw(std::unique_ptr<Renderer>& renderer, bool beam, double finer,
                 const scene::SceneAt& now, const scene::Aim& aim) {
        if (!renderer) {
            scene::Scene changed = scene_;
            changed.surfaces[0].isolation.method = scene::Method::amp_sign;
            changed.surfaces[0].isolation.beam = beam;
            changed.surfaces[0].isolation.step /= finer;
            scenes_.push_back(std::make_unique<scene::Scene>(std::move(changed)));
            const scene::Scene& drawn = *scenes_.back();
            renderer = std::make_unique<Renderer>(
                context_, drawn,
                RenderOptions{drawn.output.width,
                              drawn.output.height,
                              {shader::Channel::verdict, shader::Channel::position},
                              {}});
        }
        return renderer->draw(now, aim);
    }

    gpu::Context& context_;
    const scene::Scene& scene_;
    std::vector<std::unique_ptr<scene::Scene>> scenes_; // that renderers refer to
    std::unique_ptr<Renderer> plain_, beams_[3];
};

class Beams : public Drawing {
protected:
    static constexpr const char* size = "output.size=[97,61]"; // no multiple of any block

    Comparison compare(Views& views, const scene::SceneAt& now, const scene::Aim& aim = {}) {
        Comparison result;
        const Picture plain = views.plain(now, aim);
        const Picture beams = views.beams(now, aim, 0);
        std::vector<Picture> finer;
        const auto channel = [](const Picture& picture, const char* name) {
            return std::span<const float>(picture.frame.find(name)->samples);
        };
        const auto found = [&](const Picture& picture, std::size_t k) {
            const auto verdict = Verdict(int(channel(picture, "verdict")[k]));
            return verdict == Verdict::hit || verdict == Verdict::zero_gradient;
        };
        // Depth along the picture's axis tells the first root from later ones.
        const glm::dvec3 ahead = glm::normalize(now.camera.target - now.camera.position);
        const auto depth = [&](const Picture& picture, std::size_t k) {
            const glm::dvec3 p(channel(picture, "P.X")[k], channel(picture, "P.Y")[k],
                               channel(picture, "P.Z")[k]);
            return glm::dot(p - now.surfaces[0].placement.translate, ahead);
        };
        const double near = 0.02 * now.surfaces[0].bounds.radius * now.surfaces[0].placement.scale;
        const auto is_lost = [&](const Picture& a, std::size_t k) { return !found(a, k); };
        const auto is_later = [&](const Picture& a, std::size_t k) {
            return found(a, k) && depth(a, k) > depth(plain, k) + near;
        };
        for (std::size_t k = 0; k < channel(plain, "verdict").size(); ++k) {
            if (!found(plain, k)) continue;
            ++result.hits;
            bool lost = is_lost(beams, k), later = is_later(beams, k);
            for (std::size_t f = 0; (lost || later) && f < 2; ++f) {
                if (f == finer.size()) finer.push_back(views.beams(now, aim, f + 1));
                lost = lost && is_lost(finer[f], k);
                later = later && is_later(finer[f], k);
            }
            result.lost += lost;
            result.later += later;
        }
        return result;
    }
};
ISOMOTION_ON_EVERY_BACKEND(Beams);

scene::SceneAt moment(const scene::Scene& scene) {
    return scene::at_frame(scene, scene.output.poster);
}

TEST_P(Beams, LoseNoHitOfAnyAnimation) {
    int scenes = 0;
    for (const auto& name : scene::animation_names()) {
        SCOPED_TRACE(name);
        scene::Scene scene = scene::load(name, {"look=none", size});
        // What is compared is the eye's rays.
        scene.surfaces[0].material.reflection = scene::Material::Reflection::none;
        scene.surfaces[0].material.paint.reset();
        scene.environment.reset();
        scene.occlusion.reset();
        scene.ground.reset();
        for (auto& light : scene.lights) light.shadow = false;
        if (scene.surfaces[0].field->value.instructions.size() > 400) continue; // slow to compile
        Views views(*context, scene);
        const Comparison result = compare(views, moment(scene));
        EXPECT_GT(result.hits, 100);
        EXPECT_EQ(result.lost, 0) << "of " << result.hits;
        EXPECT_EQ(result.later, 0) << "of " << result.hits;
        ++scenes;
    }
    EXPECT_GT(scenes, 30);
}

// Kinds of field: a polynomial in a box and in a sphere, kinks, powers, sums by lists.
constexpr const char* kinds[] = {"torus", "cayley", "superquadric", "blobby75",
                                 "wyvill_soft_objects"};

TEST_P(Beams, LoseNoHitWhereverTheCameraIs) {
    for (const char* name : kinds) {
        const scene::Scene scene = scene::load(name, {"look=none", size});
        Views views(*context, scene);
        const scene::SceneAt now = moment(scene);
        const glm::dvec3 target = now.camera.target;
        const glm::dvec3 back = now.camera.position - target;
        for (const double distance : {0.05, 0.3, 0.6, 1.0, 30.0, 1e5}) {
            for (const bool parallel : {false, true}) {
                SCOPED_TRACE(fmt::format("{} from {}, parallel {}", name, distance, parallel));
                scene::SceneAt from = now;
                from.camera.position = target + distance * back;
                if (distance > 1) from.camera.zoom *= distance;
                if (parallel) {
                    from.camera.projection = scene::Camera::Projection::orthographic;
                    from.camera.height =
                        2.2 * now.surfaces[0].bounds.radius * now.surfaces[0].placement.scale;
                    from.camera.zoom = 1;
                }
                if (distance < 0.5) from.camera.fov = 100;
                const Comparison result = compare(views, from);
                EXPECT_EQ(result.lost, 0) << "of " << result.hits;
                EXPECT_EQ(result.later, 0) << "of " << result.hits;
                if (distance >= 1) {
                    EXPECT_GT(result.hits, 100);
                }
            }
        }
    }
}

TEST_P(Beams, LoseNoHitOfAnyAimOfALens) {
    const std::vector focuses{0.5, 1.0, 1.4};
    const std::vector aims{scene::Aim{{0.49, -0.49}, {1, 0}}, scene::Aim{{-0.3, 0.2}, {-0.6, 0.8}},
                           scene::Aim{{0, 0}, {0, -1}}};
    for (const char* name : {"torus", "superquadric", "blobby75"}) {
        const scene::Scene scene = scene::load(name, {"look=none", size});
        Views views(*context, scene);
        scene::SceneAt now = moment(scene);
        const double distance = glm::length(now.camera.position - now.camera.target);
        long hits = 0, pictures = 0;
        for (const bool parallel : {false, true}) {
            if (parallel) {
                now.camera.projection = scene::Camera::Projection::orthographic;
                now.camera.height =
                    2.2 * now.surfaces[0].bounds.radius * now.surfaces[0].placement.scale;
            }
            for (const double aperture : {0.05, 0.8}) {
                now.camera.aperture = aperture * distance;
                for (const auto& [focus, aim] : pairs_of(focuses, aims)) {
                    now.camera.focus = focus * distance;
                    SCOPED_TRACE(fmt::format("{}, aperture {}, focus {}, lens {} {}, {}", name,
                                             aperture, focus, aim.lens.x, aim.lens.y,
                                             parallel ? "parallel" : "from the eye"));
                    const Comparison result = compare(views, now, aim);
                    hits += result.hits;
                    ++pictures;
                    EXPECT_EQ(result.lost, 0) << "of " << result.hits;
                    EXPECT_EQ(result.later, 0) << "of " << result.hits;
                }
            }
        }
        EXPECT_GT(hits, pictures * 200);
    }
}

// Pictures of a single pixel, of less than a block, of one more than blocks; and in tiles that no
// block fits, where a beam's pixels are counted from the tile's corner.
TEST_P(Beams, PicturesOfAnySizeAndTiling) {
    for (const auto& [width, height] :
         {std::pair{1, 1}, {3, 7}, {8, 8}, {9, 17}, {64, 65}, {129, 5}, {300, 270}}) {
        const scene::Scene scene = scene::load(
            "blobby75", {"look=none", fmt::format("output.size=[{},{}]", width, height)});
        Views views(*context, scene);
        const Comparison result = compare(views, moment(scene));
        if (std::min(width, height) > 8) {
            EXPECT_GT(result.hits, width * height / 10);
        }
        EXPECT_EQ(result.lost, 0) << width << " x " << height;
        EXPECT_EQ(result.later, 0) << width << " x " << height;
    }
    for (const char* name : {"torus", "blobby75"}) {
        const scene::Scene scene = scene::load(
            name, {"look=none", size, "isolation.method=\"hermite\"", "isolation.beam=true"});
        const int frame = scene.output.poster;
        const Picture whole = draw(*context, scene, frame);
        for (const MarchPlan plan :
             {MarchPlan{16, 16, 64}, MarchPlan{37, 23, 300}, MarchPlan{64, 61, 64}}) {
            SCOPED_TRACE(
                fmt::format("{} in tiles of {} x {}", name, plan.tile_width, plan.tile_height));
            const Picture tiled = draw(*context, scene, frame, plan);
            const auto &a = whole.frame.find("verdict")->samples,
                       &b = tiled.frame.find("verdict")->samples;
            int different = 0;
            for (std::size_t k = 0; k < a.size(); ++k) different += a[k] != b[k];
            EXPECT_LE(different, 1);
        }
    }
}

// Pieces are anywhere in the range, and those of proofs up to half of it before.
TEST(BeamRange, RoundsAsRaysDoAtTheDepthsOfPieces) {
    constexpr unsigned seed = 20261127;
    std::mt19937 numbers(seed);
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(numbers);
    };
    int seen = 0;
    for (int k = 0; k < 60; ++k) {
        const auto triple = [&](double most) {
            return fmt::format("[{}, {}, {}]", between(-most, most), between(-most, most),
                               between(-most, most));
        };
        const double radius = std::pow(10.0, between(-3, 3)), far = std::pow(10.0, between(-1, 3));
        const std::string text = fmt::format(
            "[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\n"
            "bounds = {{ sphere = {}, centre = {} }}\n[camera]\nposition = {}\ntarget = {}\n{}\n",
            radius, triple(3 * radius), triple(far * radius), triple(2 * radius),
            k % 4 == 0 ? fmt::format("projection = 'orthographic'\nheight = {}", 3 * radius)
                       : fmt::format("fov = {}", between(1, 170)));
        SCOPED_TRACE(text);
        const scene::Scene scene = scene_of(text);
        const scene::SceneAt now = scene::in_formula_coordinates(scene::at_frame(scene, 1));
        const scene::Rays rays = scene::rays(now, 64, 48);
        const double depth = glm::dot(rays.axis, glm::normalize(glm::cross(rays.up, rays.right)));
        const auto allowed = scene::ray_rounding(rays, now.surfaces[0].bounds, scene::Norm::length);
        const glm::vec4 beam = beam_range(now, 64, 48, {}, 8);
        const double range = double(beam.y) - double(beam.x);
        if (range <= 0) continue; // the bounds are behind the eye
        ++seen;
        for (const double tau : {beam.x - 0.5 * range, double(beam.x), double(beam.y)}) {
            EXPECT_GE(beam.w, 0.99999 * beam_roundings * allowed.at_depth(std::abs(tau) * depth))
                << "tau " << tau;
        }
    }
    EXPECT_GT(seen, 30);
}

} // namespace
} // namespace isomotion::render
