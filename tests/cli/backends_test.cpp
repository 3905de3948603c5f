// Every back end draws the same pictures: scenes that together use every pass of the renderer. What
// pictures mean is tested on one back end.
#include "cli.h"

#include <map>

#include "on_display.h"
#include "unit/image/compare.h"

namespace isomotion::cli {
namespace {

struct BackEndScene {
    const char* name;
    Words arguments;
};

void PrintTo(const BackEndScene& scene, std::ostream* out) { *out << scene.name; }

// Every effect that a plain torus can show at once.
constexpr const char* effects = R"toml([surface]
formula = "(x^2 + y^2 + z^2 + 0.6)^2 - 2.6*(x^2 + y^2) + dent*x"
bounds = { sphere = 2 }
[parameters]
dent = "0.1*sin(t)"
[time]
fps = 30
frames = 30
[camera]
position = ["3 + t", 2, 3]
target = [0, 0, 0]
fov = 40
shutter = 0.5
aperture = 0.02
[output]
samples = 2
background = { top = [0.1, 0.2, 0.4], bottom = [0.5, 0.5, 0.5] }
[material]
model = "blinn-phong"
inside = [0.8, 0.2, 0.1]
reflection = "self"
[occlusion]
[ground]
height = -1
[fog]
density = 0.02
[[lights]]
direction = [1, 2, 3]
shadow = true
[[lights]]
position = [0, 4, 1]
shadow = true
)toml";

// An array so long that it lies in a texture.
constexpr const char* long_array = R"toml([surface]
formula = "x^2 + y^2 + z^2 - 1 + sum(links, px*sin(x + px))"
bounds = { sphere = 1.5 }
[arrays.links]
count = 5000
px = "1e-5*i"
[camera]
position = [5, 0, 0]
)toml";

const std::string every_channel = "z,n,p,verdict,evaluations,velocity";

const BackEndScene scenes[] = {
    {"fused_pass", {"twisting_superquadric", "--set", "look=none", "--frames", "20"}},
    {"beams_and_lists",
     {"blobby75", "--set", "look=none", "--frames", "31", "--method", "hermite"}},
    {"beams_of_lights", {"chmutov_12_two_lights", "--set", "output.samples=1", "--frames", "20"}},
    {"mirrors_in_a_studio", {"blobby75_chrome", "--set", "output.samples=1", "--frames", "38"}},
    {"effects", {"effects.toml", "--frames", "7"}},
    {"compute_stage", {"effects.toml", "--frames", "7", "--stage", "compute"}},
    {"array_in_a_texture", {"long_array.toml", "--frames", "1"}},
    {"proofs",
     {"barth_sextic", "--set", "look=none", "--frames", "31", "--certify", "--channels",
      every_channel + ",proof"}},
    {"proofs_of_sums",
     {"blobby75", "--set", "look=none", "--frames", "61", "--certify", "--channels", "z,proof"}},
    {"marching", {"goursat", "--frames", "1", "--method", "marching"}},
    {"amp_sign", {"goursat", "--frames", "1", "--method", "amp-sign"}},
    {"amp_taylor", {"goursat", "--frames", "1", "--method", "amp-taylor"}},
    {"interval", {"goursat", "--frames", "1", "--method", "interval"}},
    {"affine", {"goursat", "--frames", "1", "--method", "affine"}},
    {"sphere", {"goursat", "--frames", "1", "--method", "sphere"}},
};

class BackEnds : public Cli, public testing::WithParamInterface<BackEndScene> {
protected:
    BackEnds() {
        write("effects.toml", effects);
        write("long_array.toml", long_array);
    }

    // The picture by a back end, whose renderer is noted; none where this machine lacks it.
    std::optional<image::Frame> draw(const std::string& backend) {
        Words words{"render", "--size", "96x96", "--backend", backend, "-o", backend + ".exr"};
        const Words& more = GetParam().arguments;
        if (std::find(more.begin(), more.end(), "--channels") == more.end()) {
            words.insert(words.end(), {"--channels", every_channel});
        }
        words.insert(words.end(), more.begin(), more.end());
        const Ending ending = run(words);
        if (ending.code == 3) return std::nullopt;
        EXPECT_EQ(ending.code, 0) << ending;
        EXPECT_THAT(ending.out, HasSubstr("(" + backend));
        // Between the semicolon and the back end of `... step 0.02; llvmpipe (LLVM 15.0.6)
        // (osmesa)`.
        const std::size_t begin = ending.out.find("; ") + 2;
        renderers_[backend] =
            ending.out.substr(begin, ending.out.rfind(" (", ending.out.find('\n')) - begin);
        return image::decode(*this / (backend + ".exr"));
    }

    // On one renderer the pictures are identical. Where one back end reaches a graphics card and
    // another the processor, arithmetic differs in its last bits: a pixel on a silhouette may then
    // fall to either side, any other keeps its colour.
    void expect_same(const image::Frame& a, const image::Frame& b, const std::string& other) {
        SCOPED_TRACE(other);
        const bool same_renderer = renderers_["egl"] == renderers_[other];
        const image::Comparison comparison = image::compare(a, b, same_renderer ? 0 : 0.01);
        ASSERT_TRUE(comparison.same_size);
        ASSERT_TRUE(comparison.only_in_first.empty() && comparison.only_in_second.empty());
        for (const auto& channel : comparison.channels) {
            if (!same_renderer && channel.name == "evaluations") continue; // follow the last bits
            EXPECT_LE(channel.over_tolerance, same_renderer ? 0u : 96u * 96u / 100)
                << channel.name << " " << channel.largest;
        }
    }

private:
    display::OnDisplay display_;
    std::map<std::string, std::string> renderers_;
};
INSTANTIATE_TEST_SUITE_P(Passes, BackEnds, testing::ValuesIn(scenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST_P(BackEnds, DrawTheSame) {
    const auto by_egl = draw("egl");
    if (!by_egl) GTEST_SKIP() << "egl does not work here";
    EXPECT_GE(by_egl->channels.size(), 5u);
    int others = 0;
    for (const std::string backend : {"osmesa", "glfw"}) {
        if (const auto picture = draw(backend)) {
            ++others;
            expect_same(*by_egl, *picture, backend);
        }
    }
    if (others == 0) GTEST_SKIP() << "there is no other back end here";
}

} // namespace
} // namespace isomotion::cli
