// The GLSL of a field against the same formula in double on the CPU, on every back end.
#include "field_on_gpu.h"

#include <cstdio>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "float_range.h"
#include "scenes.h"
#include "thorough.h"
#include "unit/gpu/every_backend.h"
#include "unit/surface_formulas.h"

namespace isomotion::shader {
namespace {

using formula::Op;

constexpr double saturation = 1e30;

class Random {
public:
    float in(float low, float high) {
        return low + (high - low) * (float(engine_() >> 8) * 0x1p-24f);
    }
    glm::vec3 point(float reach) {
        return {in(-reach, reach), in(-reach, reach), in(-reach, reach)};
    }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 d = point(1);
            if (glm::dot(d, d) > 0.01f) return glm::normalize(d);
        }
    }

private:
    std::mt19937 engine_{seed()};

    static unsigned seed() {
        const char* given = std::getenv("ISOMOTION_SEED");
        const unsigned seed = given ? unsigned(std::strtoul(given, nullptr, 10)) : 20260u;
        std::printf("seed %u (ISOMOTION_SEED)\n", seed);
        return seed;
    }
};

// A field with values for its names.
struct Subject {
    std::string name;
    formula::Field field;
    formula::Bindings<float> bindings;
    double reach = 1;
    std::size_t random_points = 320;
};

// The origin, axes, diagonals and ends of the bounds, and far outside up to where floats end.
std::vector<Probe> probes_of(const Subject& subject, Random& random) {
    std::vector<Probe> probes;
    const auto add = [&](glm::vec3 p) { probes.push_back({p, random.direction()}); };
    for (std::size_t k = 0; k < subject.random_points; ++k) add(random.point(float(subject.reach)));
    const glm::vec3 shapes[] = {{1, 0, 0},  {0, 1, 0}, {0, 0, 1},  {1, 1, 0},
                                {0, 1, -1}, {1, 1, 1}, {1, -1, 1}, {-1, 0.5f, 0.25f}};
    add({0, 0, 0});
    const auto reach = float(subject.reach);
    for (const float s : {reach, -reach, 1.0f, -1.0f, 0.5f, 2.0f, 1e-3f, 1e-20f, 1e-41f, -10.0f,
                          1e3f, 1e6f, -1e10f, 1e20f, 3e38f}) {
        for (const glm::vec3 shape : shapes) add(s * shape);
    }
    // Along an axis a direction has components of 0.
    for (std::size_t k = 0; k < probes.size(); k += 7) probes[k].d = {0, 0, k % 2 ? 1.0f : -1.0f};
    return probes;
}

class Tally {
public:
    explicit Tally(const Subject& subject)
        : subject_(subject) {}

    void compare(float gpu, double cpu, const Range& range, const FloatRanges& all, const Probe& at,
                 const std::string& what) {
        const auto place = [&] {
            return fmt::format(
                "{} of {} at ({:.9g}, {:.9g}, {:.9g}) along ({:.9g}, {:.9g}, {:.9g}): "
                "gpu {:.9g}, double {:.12g}, floats may give {:.12g} to {:.12g}{}",
                what, subject_.name, at.p.x, at.p.y, at.p.z, at.d.x, at.d.y, at.d.z, gpu, cpu,
                range.low, range.high, range.nan ? " or NaN" : "");
        };
        if (std::isnan(cpu)) return;
        if ((range.nan && std::isnan(gpu)) || (all.strained && !std::isfinite(gpu))) {
            ++beyond_floats_;
            return;
        }
        ASSERT_FALSE(std::isnan(gpu)) << place();
        ASSERT_TRUE(range.contains(double(gpu))) << place();
        if (!all.saturated) {
            ASSERT_TRUE(contains_nearly(range, cpu)) << place();
        }
        if (std::abs(cpu) > saturation && !range.contains(0)) {
            ASSERT_EQ(gpu > 0, cpu > 0) << place();
        }
    }

    // Where pictures are made: how much of the range is used, and whether it is narrow at all. A
    // bound of everything proves nothing.
    void measure(float gpu, double cpu, const Range& range, bool saturated) {
        if (saturated || std::isnan(cpu)) return;
        ++inside_;
        if (range.high - range.low <= 1e-2 * std::max(1.0, std::abs(cpu))) ++narrow_;
        const double bound = std::max(range.high - cpu, cpu - range.low);
        const double error = std::abs(double(gpu) - cpu);
        if (!(bound > std::numeric_limits<float>::min()) || error / bound <= worst_) return;
        worst_ = error / bound;
        worst_error_ = error;
        worst_value_ = cpu;
    }

    void print() const {
        std::printf("%-26s worst ratio %.3f (off by %.2g at %.3g), beyond floats %d\n",
                    subject_.name.c_str(), worst_, worst_error_, worst_value_, beyond_floats_);
    }

    double narrow_share() const { return inside_ ? double(narrow_) / double(inside_) : 1; }

private:
    // The range's own arithmetic is double.
    static bool contains_nearly(const Range& range, double value) {
        const double slack = 1e-12 * (std::abs(value) + 1);
        return range.low - slack <= value && value <= range.high + slack;
    }

    const Subject& subject_;
    double worst_ = 0, worst_error_ = 0, worst_value_ = 0;
    int beyond_floats_ = 0, inside_ = 0, narrow_ = 0;
};

void expect_agreement(const Subject& subject, Random& random, double least_narrow = 0.9) {
    const std::vector<Probe> probes = probes_of(subject, random);
    const auto bindings = formula::convert<double>(subject.bindings);
    Tally tally(subject);
    std::array<double, 3> expected{};
    const auto results = run_on_gpu(subject.field, subject.bindings, probes);
    for (std::size_t f = 0; f < field_functions.size(); ++f) {
        const FunctionOfField& function = field_functions[f];
        const formula::Program& program = subject.field.*function.program;
        formula::Evaluator<double> cpu(program);
        for (std::size_t k = 0; k < probes.size(); ++k) {
            const Probe& at = probes[k];
            const std::array<double, 6> inputs{at.p.x, at.p.y, at.p.z, at.d.x, at.d.y, at.d.z};
            const auto ranges = float_ranges(program, bindings, inputs);
            const auto outputs = std::size_t(function.outputs);
            cpu.point(bindings, inputs, std::span(expected).first(outputs));
            for (std::size_t o = 0; o < outputs; ++o) {
                tally.compare(results[f][k][int(o)], expected[o], ranges.outputs[o], ranges, at,
                              fmt::format("{}[{}]", function.name, o));
                if (testing::Test::HasFatalFailure()) return;
                if (k < subject.random_points) {
                    tally.measure(results[f][k][int(o)], expected[o], ranges.outputs[o],
                                  ranges.saturated);
                }
            }
        }
    }
    tally.print();
    EXPECT_GE(tally.narrow_share(), least_narrow) << subject.name;
}

class FieldOnGpu : public gpu::EveryBackend {
protected:
    static void SetUpTestSuite() { use_shaders_of_source_tree(); }
    Random random;
};
ISOMOTION_ON_EVERY_BACKEND(FieldOnGpu);

Subject without_arrays(const std::string& text, double reach) {
    formula::Vocabulary vocabulary;
    vocabulary.parameters = {"a", "b"};
    return {text, formula::make_field(text, vocabulary), {{1.25f, -0.7f}, {}, 0}, reach};
}

const std::vector<std::string>& operation_formulas() {
    static const std::vector<std::string> formulas{
        "-(x*y)", "abs(x)", "sign(x)", "sqrt(x)", "exp(x)", "log(x)", "sin(x)", "cos(x)", "tan(x)",
        "sinh(x)", "cosh(x)", "tanh(x)", "asin(x)", "acos(x)", "atan(x)", "asinh(x)", "acosh(x)",
        "erf(x)", "noise(3*x, y, z)", "cbrt(x)", "cbrt(x*y)*erf(z)", "asinh(x)*acosh(y + 2)",
        "floor(x)", "x + y", "x - y", "x*y", "x/y", "min(x, y)", "max(x, y)", "min(x, y, z, 0.5)",
        "smoothmin(x, y, 0.5)", "smoothmin(x, y, z)", "x^y", "x^a", "a^x", "x^0.5", "x^3", "x^-3",
        "x^24", "x^25", "x^101", "(-2)^x", "0^x", "pow(abs(x), y)", "chebyshev(5, x)",
        "chebyshev(40, x)", "1e39*x", "1e-42*x", "x*0.1 + 0.3",
        // Compositions in which one operation's special values meet another.
        "exp(x)*exp(-x)", "sqrt(x^2 + y^2)", "exp(x)/exp(y)", "log(exp(x))", "log(abs(x))",
        "atan2(y, x)", "atan2(x - z, y)", "sin(3*atan2(y, x))", "tan(x)/tan(x)", "abs(x)^a*sign(x)",
        "1/(1 + exp(-x))", "atan(y/x)", "1/x - 1/y", "floor(x) - x + floor(-y)",
        "max(0, 1 - x^2)^3", "acos(x)*asin(y)", "tanh(a*x)*b", "abs(min(x, max(y, z)))",
        "sqrt(abs(x))*sqrt(abs(y)) - sqrt(z)", "cos(8*acos(x))", "x - -y - -1",
        "exp(-(x^2 + y^2 + z^2))", "sin(40*x)*cos(40*y)", "sinh(x) - cosh(y)"};
    return formulas;
}

TEST_P(FieldOnGpu, OperationsAgree) {
    for (const std::string& text : operation_formulas()) {
        // Many operations have poles and jumps in so large a range.
        expect_agreement(without_arrays(text, 4), random, 0.8);
        if (HasFatalFailure()) return;
    }
}

TEST(FieldOnGpuTable, NamesEveryOperation) {
    std::set<Op> seen;
    for (const std::string& text : operation_formulas()) {
        const formula::Field field = without_arrays(text, 1).field;
        for (formula::NodeId id = 0; id < field.graph.size(); ++id) seen.insert(field.graph[id].op);
        for (const FunctionOfField& function : field_functions) {
            for (const auto& now : (field.*function.program).instructions) seen.insert(now.op);
        }
    }
    // These need an array, or are for animation only.
    seen.insert({Op::element, Op::sum, Op::least, Op::pick, Op::which, Op::random});
    for (int op = 0; op <= int(Op::which); ++op) {
        EXPECT_TRUE(seen.contains(Op(op))) << formula::name(Op(op));
    }
}

// 75 places as good as any.
formula::ArrayColumns<float> spread(int count, int fields, float reach) {
    std::mt19937 engine(75);
    formula::ArrayColumns<float> array;
    array.count = count;
    for (int f = 0; f < fields; ++f) {
        auto& column = array.fields.emplace_back();
        for (int e = 0; e < count; ++e) {
            column.push_back(reach * (2 * (float(engine() >> 8) * 0x1p-24f) - 1));
        }
    }
    return array;
}

TEST_P(FieldOnGpu, SurfacesAgree) {
    for (const SurfaceFormula& surface : surface_formulas()) {
        formula::Vocabulary vocabulary;
        Subject subject;
        subject.name = surface.name;
        subject.reach = surface.reach;
        for (const auto& [name, value] : surface.parameters) {
            vocabulary.parameters.push_back(name);
            subject.bindings.parameters.push_back(float(value));
        }
        if (surface.text.find("blobs") != std::string::npos) {
            vocabulary.arrays = {{"blobs", {{"ux", {}}, {"uy", {}}, {"uz", {}}}}};
            subject.bindings.arrays = {spread(75, 3, 1)};
            subject.random_points = 100;
        }
        subject.field = formula::make_field(surface.text, vocabulary);
        expect_agreement(subject, random);
        if (HasFatalFailure()) return;
    }
}

// Six fields take two texels; `width` has one value for all links.
Subject with_arrays(const std::string& text, int blobs, int links) {
    formula::Vocabulary vocabulary;
    vocabulary.parameters = {"a", "b", "c", "m", "width"};
    vocabulary.arrays = {
        {"blobs", {{"cx", {}}, {"cy", {}}, {"cz", {}}, {"weight", {}}, {"r", {}}, {"s", {}}}},
        {"links", {{"px", {}}, {"py", {}}, {"width", 4}}}};
    Subject subject{
        fmt::format("{} [{}, {}]", text, blobs, links),
        formula::make_field(text, vocabulary),
        {{1.25f, -0.75f, 0.5f, 3, 0.125f}, {spread(blobs, 6, 1), spread(links, 3, 1)}, 0},
        1.5};
    subject.random_points = 64;
    return subject;
}

TEST_P(FieldOnGpu, SumsAgree) {
    const std::string ball = "(x-cx)^2 + (y-cy)^2 + (z-cz)^2";
    const std::vector<std::string> texts{
        "sum(blobs, exp(-4*(" + ball + "))) - a",
        "sum(blobs, weight*exp(-(4+s)*(r^2 + " + ball + "))) - b",
        // The second texel alone, and fields of both texels in another order.
        "sum(blobs, s*x + r*y) - c", "sum(blobs, s*weight + r*cx*x)",
        "sum(links, exp(-((x-px)^2 + (y-py)^2)/width)) - z",
        "sum(blobs, cx*x) + sum(links, py*y) - sum(blobs, cy*z)",
        "sum(blobs, weight*sum(links, sin(px*x + cx*y + py*z))) - a",
        "sum(links, py*sum(blobs, cos(cx + px*x)) + sum(blobs, r)*x)",
        // One sum needs the result of another.
        "q = sum(blobs, weight*x + r); sum(blobs, cos(q + cx*y)) + sum(links, q*px*z)",
        // Slopes are those of the element that is least.
        "least(blobs, sqrt(" + ball + ") - 0.3*s) - 0.2", "greatest(blobs, cx*x + cy*y + cz*z) - a",
        "min(least(blobs, " + ball + "), sum(links, px*x)) + least(links, abs(x - px)*py)",
        "least(blobs, r + greatest(links, sin(x - cx*px)*cy)) - sum(blobs, cx*greatest(links, "
        "sin(y*py)))",
        "sum(blobs, 1) - sum(links, 2)*x", "sum(blobs, min(cx, x)) + m*sum(links, max(py, y))"};
    for (const std::string& text : texts) {
        expect_agreement(with_arrays(text, 7, 4), random);
        if (HasFatalFailure()) return;
    }
}

TEST_P(FieldOnGpu, SumsOfOneAndOfNoElementsAgree) {
    for (const auto& [blobs, links] : {std::pair(1, 1), {0, 3}, {3, 0}, {0, 0}}) {
        for (const char* text :
             {"sum(blobs, weight*sum(links, px*x) + s*y) - sum(links, py*z)",
              "min(x, least(blobs, cos(y) + cx)) - max(cos(z), greatest(links, px*sin(x)))"})
            expect_agreement(with_arrays(text, blobs, links), random);
        if (HasFatalFailure()) return;
    }
}

// Longer than a uniform block, of 1,024 texels: the elements come through a texture buffer. Most of
// the time is the comparison's, at each of 145 places.
TEST_P(FieldOnGpu, ThousandsOfElementsAgree) {
    for (const char* text :
         {"sum(blobs, exp(-40*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - a",
          "sum(blobs, weight*exp(-(9+s)*(r^2 + (x-cx)^2 + (y-cy)^2 + (z-cz)^2)))"}) {
        Subject subject = with_arrays(text, trials(1100, 5000), 2);
        subject.random_points = 24;
        expect_agreement(subject, random);
        if (HasFatalFailure()) return;
    }
}

} // namespace
} // namespace isomotion::shader
