// Audits find what is wrong, call nothing wrong that is right, and change no pixel.
#include "audit/audit.h"

#include <fstream>
#include <random>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/drawing.h"
#include "render/exposure.h"
#include "scene/reading/load.h"
#include "sequence/exporter.h"
#include "sequence/manifest.h"
#include "sequence/verification.h"

namespace isomotion::audit {
namespace {

TEST(Audit, PixelsAreDifferentAndSeededByTheFrame) {
    const std::vector<int> pixels = pixels_of_frame(30, 20, 64, 7);
    EXPECT_EQ(pixels.size(), 64u);
    EXPECT_TRUE(std::is_sorted(pixels.begin(), pixels.end()));
    EXPECT_EQ(std::set<int>(pixels.begin(), pixels.end()).size(), 64u);
    EXPECT_GE(pixels.front(), 0);
    EXPECT_LT(pixels.back(), 600);
    EXPECT_EQ(pixels, pixels_of_frame(30, 20, 64, 7));
    EXPECT_NE(pixels, pixels_of_frame(30, 20, 64, 8));
    EXPECT_EQ(pixels_of_frame(3, 2, 64, 1).size(), 6u); // there are no more
    EXPECT_TRUE(pixels_of_frame(30, 20, 0, 1).empty());
}

TEST(Audit, FewRaysSayLittle) {
    // (1 - p)^n = 5 %.
    for (const std::int64_t rays : {1, 64, 30'720, 1'000'000})
        EXPECT_NEAR(std::pow(1 - most_wrong(rays), double(rays)), 0.05, 1e-9) << rays;
    EXPECT_EQ(most_wrong(0), 1);
}

TEST(Audit, SaysWhatItFound) {
    EXPECT_EQ(words({.rays = 30'720}, 120),
              "audited 30,720 rays of 120 frames: none wrong (at most 98 in a million, 95 % sure)");
    EXPECT_EQ(words({.rays = 30'720, .undecided = 5000}, 120),
              "audited 30,720 rays of 120 frames: none wrong (at most 98 in a million of such "
              "rays, 95 % sure); truth can't tell of 5,000 more");
    EXPECT_EQ(words({.rays = 64, .undecided = 2, .wrong = 3}, 1),
              "audited 64 rays of 1 frame: 3 wrong; truth can't tell of 2 more");
    EXPECT_EQ(words({.undecided = 5}, 1), "audited 0 rays of 1 frame; truth can't tell of 5 more");
}

TEST(Audit, TakesAPartOfTheDrawing) {
    EXPECT_EQ(affordable(1, 0, 100), 64); // nothing known yet
    EXPECT_EQ(affordable(1, 1e-5, 100), 3000);
    EXPECT_EQ(affordable(0.001, 1e-5, 100), 64);
    EXPECT_EQ(affordable(1000, 1e-6, 100), 16'384);
    // Sums of a hundred thousand elements and more.
    EXPECT_EQ(affordable(1, 0, 1e6), 2);
    EXPECT_EQ(affordable(1, 0, 1e8), 0);
}

const char* const body = R"toml(
[surface]
formula = "max(x^2 + y^2 + z^2 - 1, 0.2 - abs(x - y))"
bounds = { sphere = 1.3 }
[output]
size = [90, 70]
)toml";

class Audits : public render::Drawing {
protected:
    render::Picture with_endings(const scene::Scene& scene, int rays, int width = 90,
                                 int height = 70) {
        render::Renderer renderer(*context, scene,
                                  {.width = width, .height = height, .tells_endings = true});
        render::FrameInputs inputs = renderer.prepare(scene, 1);
        inputs.pictures.front().endings_of = pixels_of_frame(width, height, rays, 1);
        now = inputs.now;
        aim = inputs.pictures.front().aim;
        grid = render::grid(inputs.pictures.front().surfaces[0]);
        return render::expose(renderer, inputs);
    }
    scene::SceneAt now;
    scene::Aim aim;
    std::shared_ptr<const elements::ElementGrid> grid;
};
ISOMOTION_ON_EVERY_BACKEND(Audits);

TEST_P(Audits, RightPicturesAreFoundRight) {
    const scene::Scene scene = render::scene_of(body);
    const render::Picture picture = with_endings(scene, 2000);
    ASSERT_EQ(picture.endings.size(), 2000u);
    const Findings found = Auditor(scene).hold(1, now, aim, 90, 70, picture.endings);
    EXPECT_EQ(found.wrong, 0);
    EXPECT_EQ(found.rays + found.undecided, 2000);
    EXPECT_GT(found.rays, 1950);
    const auto hits = std::count_if(picture.endings.begin(), picture.endings.end(),
                                    [](const render::Ending& ending) { return ending.is_hit(); });
    EXPECT_GT(hits, 200);
    EXPECT_LT(hits, 1800);
}

TEST_P(Audits, EveryKindOfFaultIsFound) {
    const scene::Scene scene = render::scene_of(body);
    const render::Picture picture = with_endings(scene, 500);
    std::set<roots::Fault> faults;
    for (const render::Ending& right : picture.endings) {
        render::Ending wrong = right;
        std::set<roots::Fault> may{roots::Fault::missed};
        if (!right.is_hit()) {
            wrong.t = 0.1f;
            may = {roots::Fault::false_hit, roots::Fault::wrong_root};
        } else if (right.row % 3 == 0) {
            wrong.t = render::Ending::nowhere;
        } else if (right.row % 3 == 1) {
            wrong.t = render::Ending::unknown;
        } else {
            wrong.t += 0.3f;
            may = {roots::Fault::wrong_root};
        }
        const Findings found = Auditor(scene).hold(4, now, aim, 90, 70, {&wrong, 1});
        if (found.undecided > 0 || found.wrong == 0) continue; // a ray that touches
        ASSERT_EQ(found.examples.size(), 1u);
        EXPECT_EQ(found.examples[0].frame, 4);
        EXPECT_EQ(found.examples[0].column, right.column);
        EXPECT_TRUE(may.count(found.examples[0].fault)) << roots::words(found.examples[0].fault);
        faults.insert(found.examples[0].fault);
    }
    EXPECT_EQ(faults.size(), 3u);
}

// The audit follows the ray of the sample that was drawn first, not that of the pixel's middle.
TEST_P(Audits, OfPicturesOfSeveralSamples) {
    const scene::Scene scene = render::scene_of(std::string(body) + "samples = 4\n");
    const render::Picture picture = with_endings(scene, 1500);
    EXPECT_EQ(picture.endings.size(), 1500u);
    EXPECT_EQ(Auditor(scene).hold(1, now, aim, 90, 70, picture.endings).wrong, 0);
}

// The picture's grid of elements serves the audit as one that it makes itself.
TEST_P(Audits, ByThePicturesOwnGrid) {
    const scene::Scene scene = render::scene_of(R"toml(
[surface]
formula = "0.3 - sum(p, exp(-120*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))"
bounds = { sphere = 1.4 }
[arrays.p]
count = 700
cx = "1.8*random(i, 0) - 0.9"
cy = "1.8*random(i, 1) - 0.9"
cz = "1.8*random(i, 2) - 0.9"
[output]
size = [90, 70]
)toml");
    const render::Picture picture = with_endings(scene, 600);
    ASSERT_TRUE(grid);
    const Findings own = Auditor(scene).hold(1, now, aim, 90, 70, picture.endings);
    const Findings given = Auditor(scene).hold(1, now, aim, 90, 70, picture.endings, {}, grid);
    EXPECT_EQ(given.rays, own.rays);
    EXPECT_EQ(given.undecided, own.undecided);
    EXPECT_EQ(given.wrong, 0);
    // A grid that lists no element: the picture would be found wrong.
    auto empty = std::make_shared<elements::ElementGrid>(*grid);
    for (elements::Cell& cell : empty->cells) cell.packed = 0;
    EXPECT_GT(Auditor(scene).hold(1, now, aim, 90, 70, picture.endings, {}, empty).wrong, 50);
}

TEST_P(Audits, ChangeNoPixel) {
    for (const char* more : {"", "[isolation]\nmethod = \"affine\"\n",
                             "[[lights]]\ndirection = [1, 1, 2]\nshadow = true\n"}) {
        const scene::Scene scene = render::scene_of(std::string(body) + more);
        render::Renderer plain(*context, scene, {.width = 90, .height = 70});
        const render::FrameInputs inputs = plain.prepare(scene, 1);
        const render::Picture picture = render::expose(plain, inputs);
        EXPECT_TRUE(render::same_bits(picture.frame, with_endings(scene, 100).frame)) << more;
        render::Renderer other(*context, scene, {.width = 90, .height = 70, .tells_endings = true});
        EXPECT_EQ(other.shaders_fingerprint(), plain.shaders_fingerprint());
        EXPECT_EQ(other.prepare(scene, 1).fingerprint, inputs.fingerprint);
    }
}

// Stairs z = floor(3 x) / 3: every ray from above meets a tread or a wall, whose normal is -x.
TEST_P(Audits, JumpsAreWallsWhereAskedFor) {
    const std::string stairs = R"toml(
[surface]
formula = "z - floor(3*x)/3"
jumps = true
bounds = { box = [[-1, -1, -1.5], [1, 1, 1.5]] }
[camera]
azimuth = 190
elevation = 20
[output]
size = [90, 70]
)toml";
    for (const char* method : {"hermite", "affine", "interval", "sphere"}) {
        SCOPED_TRACE(method);
        const scene::Scene scene =
            render::scene_of(stairs + fmt::format("[isolation]\nmethod = \"{}\"\n", method));
        const render::Picture picture = with_endings(scene, 6300);
        const Findings found = Auditor(scene).hold(1, now, aim, 90, 70, picture.endings);
        EXPECT_EQ(found.wrong, 0);
        EXPECT_GT(found.rays, 5900);
        render::Renderer renderer(
            *context, scene, {.width = 90, .height = 70, .channels = {shader::Channel::normal}});
        const render::Picture drawn = render::expose(renderer, renderer.prepare(scene, 1));
        const auto& x = drawn.frame.find("N.X")->samples;
        const auto& z = drawn.frame.find("N.Z")->samples;
        int walls = 0, treads = 0;
        for (std::size_t k = 0; k < x.size(); ++k) {
            walls += std::abs(x[k] + 1) < 1e-5;
            treads += std::abs(z[k] - 1) < 1e-5;
            EXPECT_TRUE(std::isnan(x[k]) || std::abs(x[k]) + std::abs(z[k]) < 1.0001f) << k;
        }
        EXPECT_GT(walls, 500);
        EXPECT_GT(treads, 200);
    }
}

// A step that is far too long, so that the method misses what the audit must find.
TEST_P(Audits, ExportsWarnAndRecord) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / fmt::format("isomotion-audit-{}", getpid());
    fs::remove_all(folder);
    for (const bool is_wrong : {true, false}) {
        const scene::Scene scene =
            render::scene_of(std::string(body) +
                             (is_wrong ? "[isolation]\nmethod = \"marching\"\nstep = 0.5\n" : ""));
        sequence::ExportOptions options;
        options.output = (folder / (is_wrong ? "wrong.####.png" : "right.####.png")).string();
        options.frames = {1, 2, 3};
        options.audit = 400;
        std::vector<std::string> warnings;
        sequence::ExportWatcher watcher;
        watcher.warn = [&](const std::string& text) { warnings.push_back(text); };
        sequence::ExportProgress last;
        watcher.progress = [&](const sequence::ExportProgress& now) { last = now; };
        sequence::Exporter exporter(scene, options);
        const sequence::ExportTotals totals = exporter.export_frames(*context, watcher);
        // The scene stands still: it is drawn and audited once.
        EXPECT_EQ(totals.drawn, 1);
        EXPECT_EQ(last.done, 2);
        EXPECT_EQ(last.part, 1) << "a signal leaves a frame whole that is being written";
        EXPECT_EQ(totals.audit.rays + totals.audit.undecided, 400);
        EXPECT_EQ(totals.audit.wrong > 0, is_wrong);
        EXPECT_EQ(warnings.empty(), !is_wrong);
        if (is_wrong) {
            EXPECT_NE(warnings.back().find("--method affine"), std::string::npos);
        }
        const auto found = sequence::verify(
            sequence::manifest_folder(sequence::SequenceName::parse(options.output)));
        EXPECT_TRUE(found.is_whole());
        EXPECT_EQ(found.audited, 1);
        EXPECT_EQ(found.audit[1], totals.audit.wrong);
        EXPECT_EQ(found.audit[0] + found.audit[1], totals.audit.rays);
    }
    fs::remove_all(folder);
}

} // namespace
} // namespace isomotion::audit
