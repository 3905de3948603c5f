// The GLSL of a field's interval bounds against doubles at members of the boxes, and against the
// CPU's intervals for width, on every back end.
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "field_on_gpu.h"
#include "formula/enclosure.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"
#include "scenes.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader::interval_on_gpu_test {
namespace {

using formula::Interval;

constexpr float inf = std::numeric_limits<float>::infinity();

class Random {
public:
    float in(float low, float high) {
        return low + (high - low) * (float(engine_() >> 8) * 0x1p-24f);
    }
    std::size_t below(std::size_t bound) { return engine_() % bound; }

private:
    std::mt19937 engine_{seed()};

    static unsigned seed() {
        const char* given = std::getenv("ISOMOTION_SEED");
        const unsigned seed = given ? unsigned(std::strtoul(given, nullptr, 10)) : 20260u;
        std::printf("seed %u (ISOMOTION_SEED)\n", seed);
        return seed;
    }
};

constexpr double most(glm::vec2) { return double(3e38f); }
constexpr double most(glm::dvec2) { return std::numeric_limits<double>::max(); }

template<class Ends> double member(Random& random, Ends a) {
    const double lo = std::max(double(a.x), -most(a)), hi = std::min(double(a.y), most(a));
    const double part = random.below(3) == 0 ? double(random.below(2)) : double(random.in(0, 1));
    return std::clamp(lo * (1 - part) + hi * part, lo, hi);
}

template<class Ends> std::string describe(const std::array<Ends, 6>& box) {
    std::string text;
    for (const Ends a : box) text += fmt::format("[{:.17g}, {:.17g}] ", a.x, a.y);
    return text;
}

// A field on both sides. What it is at a member, slopes included, the CPU knows as an interval that
// is hardly wider than a double (but where slopes jump): the GPU's bound must meet it.
class Subject {
public:
    Subject(std::string name, const formula::Field& field, formula::Bindings<float> bindings)
        : name_(std::move(name))
        , field_(field)
        , floats_(std::move(bindings))
        , intervals_(formula::convert<Interval>(floats_))
        , programs_(formula::enclosure_programs(field))
        , value_(programs_.value)
        , along_(programs_.directional)
        , gradient_(programs_.gradient) {}

    Subject(const Subject&) = delete;
    Subject& operator=(const Subject&) = delete;

    std::vector<GpuBounds> on_gpu(const std::vector<GpuBox>& boxes) const {
        return bounds_on_gpu(field_, floats_, boxes);
    }

    std::vector<DoubleBox> in_doubles(const std::vector<DoubleBox>& boxes) const {
        return double_bounds_on_gpu(field_, floats_, boxes);
    }

    template<class Ends> std::array<Interval, 6> on_cpu(const std::array<Ends, 6>& box) {
        std::array<Interval, 6> inputs;
        for (std::size_t k = 0; k < 6; ++k) inputs[k] = {double(box[k].x), double(box[k].y)};
        return enclose(inputs);
    }

    void expect_holds(const GpuBox& box, const GpuBounds& bounds, Random& random, int samples) {
        expect_holds(box, bounds.outputs, random, samples);
    }

    template<class Ends>
    void expect_holds(const std::array<Ends, 6>& box, const std::array<Ends, 6>& bounds,
                      Random& random, int samples) {
        for (std::size_t o = 0; o < bounds.size(); ++o) {
            const Ends b = bounds[o];
            ASSERT_TRUE(b.x <= b.y && inf > b.x && -inf < b.y)
                << name_ << " output " << o << " over " << describe(box) << ": " << b.x << ' '
                << b.y;
        }
        for (int k = 0; k < samples; ++k) {
            std::array<Interval, 6> at;
            for (std::size_t i = 0; i < 6; ++i) at[i] = member(random, box[i]);
            const auto values = enclose(at);
            for (std::size_t o = 0; o < values.size(); ++o) {
                const Ends b = bounds[o];
                ASSERT_TRUE(double(b.x) <= values[o].hi && values[o].lo <= double(b.y))
                    << name_ << " output " << o << " over " << describe(box)
                    << fmt::format(": [{:.17g}, {:.17g}] lacks {:.17g} to {:.17g}", b.x, b.y,
                                   values[o].lo, values[o].hi);
            }
        }
    }

private:
    std::array<Interval, 6> enclose(const std::array<Interval, 6>& inputs) {
        std::array<Interval, 6> outputs;
        const std::span<const Interval> point = std::span(inputs).first(3);
        value_.point(intervals_, point, std::span(outputs).first(1));
        along_.point(intervals_, inputs, std::span(outputs).subspan(1, 2));
        gradient_.point(intervals_, point, std::span(outputs).last(3));
        return outputs;
    }

    std::string name_;
    const formula::Field& field_;
    formula::Bindings<float> floats_;
    formula::Bindings<Interval> intervals_;
    formula::EnclosurePrograms programs_;
    formula::Evaluator<Interval> value_, along_, gradient_;
};

class IntervalOnGpu : public gpu::EveryBackend {
protected:
    static void SetUpTestSuite() { use_shaders_of_source_tree(); }
    Random random;
};
ISOMOTION_ON_EVERY_BACKEND(IntervalOnGpu);

float number(Random& random) {
    static constexpr float special[]{
        0,          0,      1,         2,      0.5f,           3,      1.5707964f,
        3.1415927f, 69.07f, 69.9f,     88.7f,  1e5f,           1.1e5f, 1e8f,
        1e-3f,      1e-7f,  1e-19f,    1e-30f, 1.1754944e-38f, 1e15f,  1e19f,
        1e30f,      3e38f,  0.9999999f};
    const float sign = random.below(2) == 0 ? 1.0f : -1.0f;
    switch (random.below(4)) {
    case 0:
        return sign * special[random.below(std::size(special))];
    case 1:
        return sign * std::exp2(random.in(-125, 125));
    default:
        return random.in(-4, 4);
    }
}

glm::vec2 interval(Random& random) {
    const float a = number(random);
    switch (random.below(8)) {
    case 0:
        return {a, a};
    case 1:
        return random.below(2) == 0 ? glm::vec2(-inf, a) : glm::vec2(a, inf);
    case 2:
        return random.below(4) == 0 ? glm::vec2(-inf, inf)
                                    : glm::vec2(std::min(a, 0.0f), std::max(a, 0.0f));
    case 3: {
        const float b = a + std::abs(a) * std::exp2(random.in(-20, 0));
        return std::isfinite(b) ? glm::vec2(a, b) : glm::vec2(a, inf);
    }
    default: {
        const float b = number(random);
        return {std::min(a, b), std::max(a, b)};
    }
    }
}

constexpr const char* halves_of_chebyshev = "u = max(1, abs(x)); v = log(u + sqrt(u^2 - 1)); "
                                            "cos(14*acos(x))*cosh(14*v)";

constexpr const char* operations[] = {"-(x*y)",
                                      "abs(x)",
                                      "sign(x)",
                                      "sqrt(x)",
                                      "exp(x)",
                                      "log(x)",
                                      "sin(x)",
                                      "cos(x)",
                                      "tan(x)",
                                      "sinh(x)",
                                      "cosh(x)",
                                      "tanh(x)",
                                      "asin(x)",
                                      "acos(x)",
                                      "atan(x)",
                                      "asinh(x)",
                                      "acosh(x)",
                                      "erf(x)",
                                      "noise(x, y, z)",
                                      "cbrt(x)",
                                      "atan2(y, x)",
                                      "atan2(x - z, y)*z",
                                      "cos(3*atan2(y, x))",
                                      "sin(atan2(y, x) - z)",
                                      "floor(x)",
                                      "x + y",
                                      "x - y",
                                      "x*y",
                                      "x^2*y",
                                      "x^2*abs(y)",
                                      "a*x",
                                      "b*x",
                                      "0.1*x",
                                      "-3*x",
                                      "x + a",
                                      "x/y",
                                      "x/y^2",
                                      "1/x",
                                      "1/(1 + x^2)",
                                      "min(x, y)",
                                      "max(x, y)",
                                      "smoothmin(x, y, 0.5)",
                                      "smoothmin(x, y, z)",
                                      "x^y",
                                      "x^a",
                                      "x^0.3",
                                      "abs(x)^a",
                                      "a^x",
                                      "x^3",
                                      "x^-3",
                                      "x^25",
                                      "1e39*x",
                                      "1e-42*x",
                                      "chebyshev(2, x)",
                                      "chebyshev(5, x)",
                                      "chebyshev(14, x)",
                                      "chebyshev(50, x)",
                                      "sqrt(x^2 + y^2)",
                                      "exp(-x^2)*y",
                                      "x^257",
                                      "abs(x)^-1.5",
                                      "x^-300",
                                      "cos(5*acos(x))",
                                      "u = max(1, abs(x)); y*sqrt((u - 1)*(u + z))",
                                      "max(x, 0)^2*min(y, 0) - max(0, z)*x",
                                      "u = max(1, x); cosh(5*log(u + sqrt(u^2 - 1)))",
                                      halves_of_chebyshev};

// Boxes that are neither points nor huge: rounding is small against what they are wide.
TEST_P(IntervalOnGpu, OperationsAreAsNarrowAsTheCpus) {
    formula::Vocabulary vocabulary;
    vocabulary.parameters = {"a", "b"};
    for (const char* text : operations) {
        const formula::Field field = formula::make_field(text, vocabulary);
        Subject subject(text, field, {{1.25f, -0.7f}, {}, 0});
        std::vector<GpuBox> boxes(512);
        for (GpuBox& box : boxes) {
            for (std::size_t k = 0; k < 6; ++k) {
                const float x = random.in(-4, 4);
                box[k] = {x, x + random.in(0.01f, 1)};
            }
        }
        const auto bounds = subject.on_gpu(boxes);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const Interval cpu = subject.on_cpu(boxes[k])[0];
            const double size = formula::magnitude(cpu);
            if (!(size < 10)) continue; // tan near its poles, powers
            const glm::vec2 gpu = bounds[k].outputs[0];
            EXPECT_LE(double(gpu.y) - double(gpu.x), cpu.hi - cpu.lo + 5e-5 * (size + 1))
                << text << " over " << describe(boxes[k]);
        }
    }
}

TEST_P(IntervalOnGpu, OperationsHoldTheirValues) {
    formula::Vocabulary vocabulary;
    vocabulary.parameters = {"a", "b"};
    for (const char* text : operations) {
        const formula::Field field = formula::make_field(text, vocabulary);
        Subject subject(text, field, {{1.25f, -0.7f}, {}, 0});
        std::vector<GpuBox> boxes(1024);
        for (GpuBox& box : boxes) {
            for (std::size_t k = 0; k < 6; ++k) box[k] = k < 3 ? interval(random) : glm::vec2(1);
        }
        const auto bounds = subject.on_gpu(boxes);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            subject.expect_holds(boxes[k], bounds[k], random, 4);
            if (HasFatalFailure()) return;
        }
    }
}

// Boxes over which one factor of a slope is exactly 0 and another has no bound.
TEST_P(IntervalOnGpu, SlopesThatRestMeetNoBound) {
    formula::Vocabulary vocabulary;
    for (const char* text :
         {"u = max(1, abs(x)); y + sqrt((u - 1)*(u + 1))",
          "u = min(x, 2); y - sqrt(3*(2 - u)*(u + 1))", "y*acos(0.25*max(4, x)) - y"}) {
        const formula::Field field = formula::make_field(text, vocabulary);
        const bool is_left = std::string_view(text).starts_with("u = min");
        Subject subject(text, field, {{}, {}, 0});
        std::vector<GpuBox> boxes(64);
        std::vector<DoubleBox> double_boxes(boxes.size());
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            const float x = is_left ? random.in(2.1f, 4) : random.in(-0.9f, 0.8f);
            const float y = random.in(1, 2), d = random.in(-1, 1);
            boxes[b] = {glm::vec2(x, x + 0.1f), {y, y + 0.1f}, {0, 0}, {d, d}, {1, 1}, {0, 0}};
            for (std::size_t k = 0; k < 6; ++k) double_boxes[b][k] = boxes[b][k];
        }
        const auto expect_bounded = [&](const auto& outputs) {
            for (std::size_t o = 1; o < outputs.size(); ++o) {
                EXPECT_GT(outputs[o].x, -10) << text << ", output " << o;
                EXPECT_LT(outputs[o].y, 10) << text << ", output " << o;
            }
        };
        const auto bounds = subject.on_gpu(boxes);
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            expect_bounded(bounds[b].outputs);
            subject.expect_holds(boxes[b], bounds[b], random, 4);
        }
        if (!context->info().has(4, 0)) continue;
        for (const DoubleBox& outputs : subject.in_doubles(double_boxes)) expect_bounded(outputs);
    }
}

double double_number(Random& random) {
    static constexpr double special[]{0,
                                      0,
                                      1,
                                      0x1.0000000000001p0,
                                      0x1.fffffffffffffp-1,
                                      2,
                                      0.5,
                                      1.0 / 3,
                                      0.1,
                                      1e308,
                                      1.7976931348623157e308,
                                      2.2250738585072014e-308,
                                      1e-300,
                                      1e154,
                                      1e-154,
                                      1e30,
                                      1e39,
                                      3.4028234663852886e38,
                                      1.1754943508222875e-38,
                                      1e-39,
                                      1e-45,
                                      1e5,
                                      69.07,
                                      88.7,
                                      1.5707963267948966,
                                      3.141592653589793,
                                      1e15,
                                      9007199254740992.0};
    const double sign = random.below(2) == 0 ? 1.0 : -1.0;
    switch (random.below(4)) {
    case 0:
        return sign * special[random.below(std::size(special))];
    case 1:
        return sign * std::exp2(double(random.in(-1000, 1000)));
    default:
        return double(random.in(-4, 4)) + double(random.in(0, 1)) * 0x1p-24;
    }
}

glm::dvec2 double_interval(Random& random) {
    const double a = double_number(random), endless = HUGE_VAL;
    switch (random.below(8)) {
    case 0:
        return {a, a};
    case 1:
        return random.below(2) == 0 ? glm::dvec2(-endless, a) : glm::dvec2(a, endless);
    case 2:
        return random.below(4) == 0 ? glm::dvec2(-endless, endless)
                                    : glm::dvec2(std::min(a, 0.0), std::max(a, 0.0));
    case 3: {
        const double b = a + std::abs(a) * std::exp2(double(random.in(-50, 0)));
        return {a, b};
    }
    default: {
        const double b = double_number(random);
        return {std::min(a, b), std::max(a, b)};
    }
    }
}

TEST_P(IntervalOnGpu, OperationsOnDoublesHoldTheirValues) {
    if (!context->info().has(4, 0)) GTEST_SKIP() << "no doubles";
    formula::Vocabulary vocabulary;
    vocabulary.parameters = {"a", "b"};
    for (const char* text : operations) {
        const formula::Field field = formula::make_field(text, vocabulary);
        Subject subject(text, field, {{1.25f, -0.7f}, {}, 0});
        std::vector<DoubleBox> boxes(1024);
        for (DoubleBox& box : boxes) {
            for (std::size_t k = 0; k < 6; ++k) {
                box[k] = k < 3 ? double_interval(random) : glm::dvec2(1);
            }
        }
        const auto bounds = subject.in_doubles(boxes);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            subject.expect_holds(boxes[k], bounds[k], random, 4);
            if (HasFatalFailure()) return;
        }
    }
}

// A sum or product and what its rounding took.
struct Rounded {
    double result, rest;
};

Rounded sum(double a, double b) {
    const double s = a + b, of_b = s - a;
    return {s, (a - (s - of_b)) + (b - of_b)};
}

Rounded product(double a, double b) { return {a * b, std::fma(a, b, -(a * b))}; }

// The CPU's intervals, about as wide as a rounding, would not tell that one was forgotten.
TEST_P(IntervalOnGpu, RoundingOfDoublesIsCounted) {
    if (!context->info().has(4, 0)) GTEST_SKIP() << "no doubles";
    struct Exact {
        const char* text;
        Rounded (*of)(double x, double y);
    };
    constexpr Exact all[]{{"x + y", [](double x, double y) { return sum(x, y); }},
                          {"x - y", [](double x, double y) { return sum(x, -y); }},
                          {"x*y", [](double x, double y) { return product(x, y); }},
                          {"0.1*x", [](double x, double) { return product(0.1, x); }},
                          {"x^2", [](double x, double) { return product(x, x); }}};
    for (const auto& [text, of] : all) {
        const formula::Field field = formula::make_field(text, {});
        std::vector<DoubleBox> boxes(512);
        for (DoubleBox& box : boxes) {
            for (glm::dvec2& ends : box) {
                ends = glm::dvec2(double(random.in(-4, 4)) + double(random.in(0, 1)) * 0x1p-26);
            }
        }
        const auto bounds = double_bounds_on_gpu(field, {}, boxes);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const auto [r, rest] = of(boxes[k][0].x, boxes[k][1].x);
            const glm::dvec2 b = bounds[k][0];
            EXPECT_TRUE(b.x < r || (b.x == r && rest >= 0)) << text << ' ' << describe(boxes[k]);
            EXPECT_TRUE(b.y > r || (b.y == r && rest <= 0)) << text << ' ' << describe(boxes[k]);
        }
    }
}

// floor at results that are whole, or were rounded to a whole number: shaders/interval/exact.glsl.
TEST_P(IntervalOnGpu, FloorJumpsWhereItsArgumentIsNotExact) {
    struct Operation {
        const char* text;
        double (*of)(double x, double y); // exact, or rounded where floats are far from exact
        float (*whole)(float y, float k); // x of a result that is k, or nearly
    };
    constexpr Operation all[]{
        {"floor(min(x, 1e9) + min(y, 1e9))", [](double x, double y) { return x + y; },
         [](float y, float k) { return k - y; }},
        {"floor(min(x, 1e9) - min(y, 1e9))", [](double x, double y) { return x - y; },
         [](float y, float k) { return k + y; }},
        {"floor(min(x, 1e9)*min(y, 1e9))", [](double x, double y) { return x * y; },
         [](float y, float k) { return k / y; }},
        {"floor(min(x, 1e9)/min(y, 1e9))", [](double x, double y) { return x / y; },
         [](float y, float k) { return k * y; }},
    };
    for (const auto& [text, of, whole] : all) {
        const formula::Field field = formula::make_field(text, {});
        std::vector<GpuBox> boxes(2048);
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            // Whole numbers, halves, numbers of 24 bits, and some that are too small to add.
            const float n = 1 + float(random.below(9)), k = float(random.below(7)) - 3;
            const float y = std::array{n, 0.5f * n, random.in(0.1f, 9), n * 0x1p-28f}[b % 4];
            boxes[b].fill(glm::vec2(1));
            boxes[b][0] = glm::vec2(b % 3 == 0 ? k : whole(y, k));
            boxes[b][1] = glm::vec2(y);
        }
        const auto bounds = bounds_on_gpu(field, {}, boxes);
        int exact = 0, rounded = 0;
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            const double value = of(double(boxes[b][0].x), double(boxes[b][1].x));
            const glm::vec2 gpu = bounds[b].outputs[0];
            EXPECT_LE(double(gpu.x), std::floor(value)) << text << ' ' << describe(boxes[b]);
            EXPECT_GE(double(gpu.y), std::floor(value)) << text << ' ' << describe(boxes[b]);
            if (value == std::floor(value) && std::abs(value) < 1e6) {
                EXPECT_LT(gpu.y - gpu.x, 0.1f) << text << ' ' << describe(boxes[b]);
                ++exact;
            } else if (float(value) == std::floor(float(value))) {
                ++rounded;
            }
        }
        EXPECT_GT(exact, 300) << text;
        EXPECT_GT(rounded, 50) << text;
    }
}

// The bounds at points are no wider than rounding makes them, which is what doubles are taken for.
TEST_P(IntervalOnGpu, RationalOperationsOnDoublesAreDoubles) {
    if (!context->info().has(4, 0)) GTEST_SKIP() << "no doubles";
    formula::Vocabulary vocabulary;
    vocabulary.parameters = {"a", "b"};
    for (const char* text :
         {"x + y", "x - y", "x*y", "x^2*y", "0.1*x", "a*x", "x + b", "x/(y^2 + 1)",
          "sqrt(x^2 + y^2)", "x^12 - 0.3*y^7", "min(x, y)*max(x, z)", "abs(x)*floor(y)"}) {
        const formula::Field field = formula::make_field(text, vocabulary);
        Subject subject(text, field, {{1.25f, -0.7f}, {}, 0});
        std::vector<DoubleBox> boxes(256);
        for (DoubleBox& box : boxes) {
            for (glm::dvec2& ends : box) ends = glm::dvec2(double(random.in(-2, 2)) + 0x1p-40);
        }
        const auto bounds = subject.in_doubles(boxes);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const Interval cpu = subject.on_cpu(boxes[k])[0];
            const glm::dvec2 gpu = bounds[k][0];
            EXPECT_LE(gpu.y - gpu.x, 1e-13 * (1 + formula::magnitude(cpu)))
                << text << " over " << describe(boxes[k]);
        }
    }
}

// Every surface of the catalogue over boxes from 10^-4 of its bounds to all of them.
TEST_P(IntervalOnGpu, BoundsOfTheCatalogueHoldAndAreNarrow) {
    const std::filesystem::path folder(ISOMOTION_SOURCE_DIR "/animations/surfaces");
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().stem().string();
        const scene::Scene scene = scene_of(fmt::format("[surface]\nuse = '{}'\n", name));
        const auto now = scene::at_frame(scene, 1);
        Subject subject(name, *scene.surfaces[0].field, now.surfaces[0].bindings);
        const auto reach = float(now.surfaces[0].bounds.radius);
        std::vector<GpuBox> boxes(256);
        for (GpuBox& box : boxes) {
            const float size = reach * std::pow(10.0f, random.in(-4, 0));
            for (std::size_t k = 0; k < 6; ++k) {
                const float x = k < 3 ? random.in(-reach, reach) : random.in(-1, 1);
                box[k] = {x, k < 3 ? x + size : x};
            }
        }
        const auto bounds = subject.on_gpu(boxes);
        std::array<double, 3> worst{}; // of values, slopes, gradients
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            subject.expect_holds(boxes[k], bounds[k], random, 4);
            if (HasFatalFailure()) return;
            const auto cpu = subject.on_cpu(boxes[k]);
            // Boxes of 1 % and more, whose width is not that of float rounding.
            if (boxes[k][0].y - boxes[k][0].x < 0.01f * reach) continue;
            for (std::size_t o = 0; o < 6; ++o) {
                const double width = cpu[o].hi - cpu[o].lo;
                if (!(width < 1e25)) continue;
                const double rounding = 1e-5 * formula::magnitude(cpu[o]) + 1e-6;
                double& ratio = worst[o < 2 ? 0 : o == 2 ? 1 : 2];
                ratio = std::max(ratio, double(bounds[k].outputs[o].y - bounds[k].outputs[o].x) /
                                            (width + rounding));
            }
        }
        std::printf("%-24s widths at most %.3f, %.3f, %.3f of the CPU's\n", name.c_str(), worst[0],
                    worst[1], worst[2]);
        EXPECT_LE(worst[0], 1.25) << name;
        // acos, at its ends, has slopes without end in floats where doubles still have one.
        if (name.ends_with("_trig")) continue;
        EXPECT_LE(worst[1], 10) << name;
        EXPECT_LE(worst[2], 10) << name;
    }
}

} // namespace
} // namespace isomotion::shader::interval_on_gpu_test
