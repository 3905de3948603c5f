#include "scenes/hard_case.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "probe/thresholds.h"
#include "roots/certify.h"

namespace isomotion::stability {
namespace {

// Drawn on the software renderer: its arithmetic is the same everywhere.
gpu::Context& context() {
    static const auto it = gpu::Context::create();
    return *it;
}

// Collects the rows of all cases and prints them when the suite ends. With ISOMOTION_BLESS it also
// writes docs/hard-cases.md.
class Table : public testing::Environment {
public:
    void add(std::string row) { rows_.push_back(std::move(row)); }

    void TearDown() override {
        if (rows_.empty()) return;
        print(stdout);
        if (!std::getenv("ISOMOTION_BLESS")) return;
        if (FILE* page = std::fopen(ISOMOTION_SOURCE_DIR "/docs/hard-cases.md", "w")) {
            fmt::print(page, "{}", preamble);
            print(page);
            std::fclose(page);
        }
    }

private:
    static constexpr const char* preamble =
        "# Hard cases\n"
        "\n"
        "The rows `default` show the result of a user who names no method; the other rows\n"
        "show methods of the paper. The pictures have about 96 x 96 pixels. Certified truth\n"
        "decides which pixels are wrong. `wrong`, `missed`, `false` and `behind` are pixels\n"
        "in a million: all wrong ones, missed roots, hits where there is no root, and hits\n"
        "behind the first root. The other columns count pixels: all hits, those that ended in\n"
        "a NaN, those that reached the step limit, and hits with a zero gradient.\n"
        "`tests/stability` holds a bound for each row. This command writes this page:\n"
        "\n"
        "    ISOMOTION_BLESS=1 build/release/tests/stability/stability_test\n"
        "\n";

    void print(FILE* out) const {
        fmt::print(out,
                   "| {:<36} | {:<10} | {:>6} | {:>8} | {:>8} | {:>8} | {:>8} | {:>4} | {:>5} "
                   "| {:>9} |\n",
                   "case", "method", "hits", "wrong", "missed", "false", "behind", "NaN", "limit",
                   "zero grad");
        fmt::print(out,
                   "|{:-<38}|{:-<12}|{:->7}:|{:->9}:|{:->9}:|{:->9}:|{:->9}:|{:->5}:|{:->6}:|"
                   "{:->10}:|\n",
                   "", "", "", "", "", "", "", "", "", "");
        for (const std::string& row : rows_) fmt::print(out, "{}\n", row);
    }

    std::vector<std::string> rows_;
};

Table& table() {
    static auto* const it = static_cast<Table*>(testing::AddGlobalTestEnvironment(new Table));
    return *it;
}
[[maybe_unused]] const Table& registered_before_main = table();

scene::Scene scene_of(const std::string& text) {
    std::vector<scene::Override> overrides;
    if (text.find("size =") == std::string::npos) overrides.push_back("output.size=[96, 96]");
    return render::scene_of(text, overrides);
}

// Truth of a case is wanted once a method.
const roots::Truth& truth_of(const std::string& text, const scene::Scene& scene) {
    static std::map<std::string, roots::Truth> known;
    const auto [at, is_new] = known.try_emplace(text);
    if (is_new) {
        at->second = roots::certify(scene, scene::at_frame(scene, 1), scene.output.width,
                                    scene.output.height);
    }
    return at->second;
}

// What a scene is drawn by that names no method.
constexpr scene::Method by_default = scene::Isolation{}.method;

// F times 2^k, as a scene with that formula is loaded.
scene::Scene of_other_values(scene::Scene scene, int k) {
    const auto field = formula::scaled(*scene.surfaces[0].field, std::ldexp(1.0, k));
    const double scale = probe::field_scale(field, scene::at_frame(scene, 1).surfaces[0]);
    scene.surfaces[0].field = std::make_shared<formula::Field>(formula::scaled(field, scale));
    return scene;
}

// The scene so many times as large, and its camera with it.
scene::SceneAt of_other_size(scene::SceneAt now, double scale) {
    now.surfaces[0].placement.translate *= scale;
    now.surfaces[0].placement.scale *= scale;
    now.camera.position *= scale;
    now.camera.target *= scale;
    now.camera.height *= scale;
    return now;
}

int different_verdicts(const image::Frame& a, const image::Frame& b) {
    const auto &x = a.find("verdict")->samples, &y = b.find("verdict")->samples;
    int different = 0;
    for (std::size_t k = 0; k < x.size(); ++k) different += x[k] != y[k];
    return different;
}

// The largest difference of depths, in parts of the depth, or of 0.1 where that is more. There are
// differences: drivers may order a product's factors otherwise.
double largest_difference(const image::Frame& a, const image::Frame& b) {
    const auto &x = a.find("Z")->samples, &y = b.find("Z")->samples;
    double largest = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (std::isfinite(x[k]) && std::isfinite(y[k]))
            largest =
                std::max(largest, double(std::abs(x[k] - y[k]) / std::max(std::abs(x[k]), 0.1f)));
    }
    return largest;
}

// Neither the size of F nor that of the scene changes what is seen.
void expect_any_size(const HardCase& a_case, const render::Picture& drawn) {
    const scene::Scene scene = scene_of(a_case.scene);
    for (const int k : {-70, 70}) {
        const scene::Scene other = of_other_values(scene, k);
        const render::Picture scaled = render::draw(context(), other);
        EXPECT_EQ(different_verdicts(drawn.frame, scaled.frame), 0) << "F times 2^" << k;
        EXPECT_LT(largest_difference(drawn.frame, scaled.frame), 1e-4) << "F times 2^" << k;
    }
    render::Renderer renderer(context(), scene,
                              {.width = scene.output.width,
                               .height = scene.output.height,
                               .channels = render::every_channel});
    const scene::SceneAt now = scene::at_frame(scene, 1);
    for (const double scale : {1e-3, 1e3}) {
        const render::Picture sized = renderer.draw(of_other_size(now, scale));
        EXPECT_LE(different_verdicts(drawn.frame, sized.frame), 2) << "scene of " << scale;
    }
}

void expect_sound(const Looked& looked) {
    EXPECT_EQ(looked.errors.nan, 0);
    EXPECT_EQ(looked.errors.step_limit, 0);
    EXPECT_EQ(looked.crooked, 0);
}

} // namespace

Looked look(const HardCase& a_case, scene::Method method) {
    const std::string& certain = a_case.truth.empty() ? a_case.scene : a_case.truth;
    const scene::Scene easy = scene_of(certain);
    scene::Scene hard = scene_of(a_case.scene);
    hard.surfaces[0].isolation.method = method;

    Looked looked;
    looked.picture = render::draw(context(), hard);
    const roots::Truth& truth = truth_of(certain, easy);
    looked.errors = accuracy::compare(scene::at_frame(easy, 1), looked.picture.frame, truth);
    looked.certain_hits = truth.counts()[std::size_t(roots::Answer::hit)];
    looked.zero_gradients = render::count(looked.picture, render::Verdict::zero_gradient);
    looked.hits = render::count(looked.picture, render::Verdict::hit) + looked.zero_gradients;

    const auto channel = [&](const char* name) -> const std::vector<float>& {
        return looked.picture.frame.find(name)->samples;
    };
    for (std::size_t k = 0; k < channel("verdict").size(); ++k) {
        const auto verdict = render::Verdict(int(channel("verdict")[k]));
        if (verdict != render::Verdict::hit && verdict != render::Verdict::zero_gradient) continue;
        const float length = std::hypot(channel("N.X")[k], channel("N.Y")[k], channel("N.Z")[k]);
        const float place = channel("P.X")[k] + channel("P.Y")[k] + channel("P.Z")[k];
        looked.crooked += !(std::abs(length - 1) < 1e-3f) || !std::isfinite(place);
    }

    const accuracy::Errors& e = looked.errors;
    const auto ppm = [&](std::int64_t pixels) { return 1e6 * double(pixels) / double(e.pixels); };
    if (a_case.is_drawn_by_chance) return looked; // others each time
    table().add(fmt::format("| {:<36} | {:<10} | {:>6} | {:>8.0f} | {:>8.0f} | {:>8.0f} | {:>8.0f} "
                            "| {:>4} | {:>5} | {:>9} |",
                            a_case.name, method == by_default ? "default" : scene::name(method),
                            looked.hits, e.wrong_ppm(), ppm(e.missed), ppm(e.false_hits),
                            ppm(e.wrong_roots), e.nan, e.step_limit, looked.zero_gradients));
    return looked;
}

std::string wrong_pixels(const Looked& looked) {
    const image::Frame& frame = looked.picture.frame;
    std::string told;
    for (std::size_t k = 0; k < looked.errors.faults.size(); ++k) {
        const roots::Fault fault = looked.errors.faults[k];
        if (fault == roots::Fault::none || fault == roots::Fault::undecided) continue;
        const auto drawn = [&](const char* name) { return frame.find(name)->samples[k]; };
        told += fmt::format("row {}, column {}: {}, verdict {}, at ({}, {}, {})\n",
                            k / std::size_t(frame.width), k % std::size_t(frame.width), words(fault),
                            drawn("verdict"), drawn("P.X"), drawn("P.Y"), drawn("P.Z"));
    }
    return told;
}

void expect_bounds(const HardCase& a_case) {
    {
        SCOPED_TRACE("by default");
        const Looked looked = look(a_case, by_default);
        EXPECT_LE(looked.errors.wrong_ppm(), a_case.by_default);
        expect_sound(looked);
        EXPECT_GT(looked.certain_hits + looked.hits, 0) << "nothing to see";
        if (!a_case.is_cut_off) expect_any_size(a_case, looked.picture);
    }
    for (const Bound& bound : a_case.bounds) {
        SCOPED_TRACE(std::string(scene::name(bound.method)));
        const Looked looked = look(a_case, bound.method);
        EXPECT_LE(looked.errors.wrong_ppm(), bound.wrong_ppm);
        if (bound.wrong_ppm == blind) {
            EXPECT_EQ(looked.errors.missed, 0);
        }
        expect_sound(looked);
    }
}

} // namespace isomotion::stability
