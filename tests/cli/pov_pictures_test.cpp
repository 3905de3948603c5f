// Files of POV-Ray drawn by POV-Ray and by this program: the same silhouettes. Skipped where povray
// is not installed.
#include "cli.h"

#include <algorithm>

namespace isomotion::cli {
namespace {

struct PovFile {
    const char* name;
    const char* text;
};

void PrintTo(const PovFile& file, std::ostream* out) { *out << file.name; }

// Turned, scaled and moved; a perspective camera; functions; cut open by a box.
constexpr PovFile isosurface{"isosurface", R"(#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare R = 2;
#declare Wave = function(a, b) { sin(3*a) * b }
camera { location <1, 2, -6> look_at <0, 0.5, 0> angle 50 right x up y }
light_source { <5, 8, -4> color rgb <1, 1, 1> }
isosurface {
  function { x*x + y*y*2 + pow(z, 2) - R*R + Wave(x + 1, 0.6) + Wave(y, 0.4) }
  threshold 0.5
  max_gradient 20
  accuracy 0.00001
  contained_by { box { <-2, -2, -1>, <3, 2, 1.5> } }
  open
  pigment { rgb <1, 0.5, 0> }
  rotate <20, 90, 10>
  scale 0.8
  translate <0, 0.6, 0.2>
}
)"};

// A torus of radii 1 and 0.5 by its coefficients, seen by an orthographic camera.
constexpr PovFile quartic{"quartic", R"(#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location <2, 3, -4> look_at <0, 0, 0> right 4*x up 4*y }
light_source { <-5, 8, -4> color rgb <1, 1, 1> parallel point_at <0, 0, 0> }
quartic {
  <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.5,
   0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
   1, 0, 0, 2, 0, 1.5, 0, 0, 0, 0,
   1, 0, -2.5, 0, 0.5625>
  sturm
  pigment { rgb <0.2, 0.6, 1> }
  rotate <30, 0, 40>
}
)"};

// A cubic without an end, clipped by a ball; its coefficients tell x, y and z apart.
constexpr PovFile poly{"poly", R"(#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <3, 2, -4> look_at <0, 0, 0> angle 45 right x up y }
light_source { <5, 8, -4> color rgb <1, 1, 1> }
poly { 3,
  <1, 0.3, 0, 0, 0, 0, 0.2, 0, 0, -1.2,
   1, 0, 0, 0, 0, -1.2, 0.7, 0.4, -1.2, 0.3>
  sturm
  clipped_by { sphere { <0.1, 0, -0.1>, 1.6 } }
  bounded_by { clipped_by }
  pigment { rgb <0.8, 0.2, 0.2> }
}
)"};

class PovPictures : public Cli, public testing::WithParamInterface<PovFile> {
protected:
    // Where a picture with a transparent background shows something.
    std::vector<bool> mask(const std::string& picture) const {
        const image::Frame decoded = image::decode(*this / picture);
        std::vector<bool> hits;
        for (const auto& channel : decoded.channels) {
            if (channel.name != "A") continue;
            for (const float alpha : channel.samples) hits.push_back(alpha > 0.5f);
        }
        return hits;
    }
};

TEST_P(PovPictures, HaveTheSilhouettesOfPovRay) {
    constexpr int side = 160;
    const std::string size = std::to_string(side);
    write("scene.pov", GetParam().text);
    Circumstances here = circumstances();
    here.folder = folder();
    const Ending drawn =
        cli::run({"/bin/sh", "-c",
                  "command -v povray >/dev/null || exit 77; povray +Iscene.pov +Opov.png +W" +
                      size + " +H" + size + " +UA -D -A +FN8"},
                 here);
    if (drawn.code == 77) GTEST_SKIP() << "povray is not installed";
    ASSERT_EQ(drawn.code, 0) << drawn;
    const Ending ours = run({"render", "scene.pov", "--size", size + "x" + size, "--set",
                             "output.background=transparent", "-o", "ours.png"});
    ASSERT_EQ(ours.code, 0) << ours;
    const std::vector<bool> a = mask("ours.png"), b = mask("pov.png");
    ASSERT_EQ(a.size(), std::size_t(side * side));
    ASSERT_EQ(b.size(), a.size());
    int hits = 0, differ = 0, off_edges = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto at = [&](int column, int row) {
                return b[std::size_t(std::clamp(row, 0, side - 1) * side +
                                     std::clamp(column, 0, side - 1))];
            };
            const bool is_hit = at(x, y);
            hits += is_hit;
            if (a[std::size_t(y * side + x)] == is_hit) continue;
            ++differ;
            bool is_edge = false;
            for (int k = 0; k < 9; ++k) is_edge |= at(x + k % 3 - 1, y + k / 3 - 1) != is_hit;
            off_edges += !is_edge;
        }
    }
    RecordProperty("differ", differ);
    EXPECT_GT(hits, side * side / 10);
    EXPECT_LT(hits, side * side * 9 / 10);
    EXPECT_EQ(off_edges, 0);
    EXPECT_LE(differ, 5) << "of " << hits;
}

INSTANTIATE_TEST_SUITE_P(Files, PovPictures, testing::Values(isosurface, quartic, poly),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace
} // namespace isomotion::cli
