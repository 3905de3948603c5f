// The GLSL of a field's models against doubles: F and its slope are off a model by no more than it
// tells, wherever points are within the models of their coordinates.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "formula/glsl/glsl_model.h"
#include "gpu/buffer.h"
#include "scenes.h"
#include "shader/field_text.h"
#include "shader/shader_text.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader::model_on_gpu_test {
namespace {

class Random {
public:
    double in(double low, double high) {
        return low + (high - low) * double(engine_() >> 8) * 0x1p-24;
    }
    int below(int bound) { return int(engine_() % unsigned(bound)); }

private:
    std::mt19937 engine_{seed()};

    static unsigned seed() {
        const char* given = std::getenv("ISOMOTION_SEED");
        const unsigned seed = given ? unsigned(std::strtoul(given, nullptr, 10)) : 20261125u;
        std::printf("seed %u (ISOMOTION_SEED)\n", seed);
        return seed;
    }
};

// Sums, products and squares of x, y, z and constants, some of them no floats.
std::string polynomial(Random& random, int depth) {
    if (depth == 0) {
        const int leaf = random.below(5);
        return leaf < 3 ? std::string(1, "xyz"[leaf]) : fmt::format("{:.3f}", random.in(-2, 2));
    }
    const auto part = [&] { return polynomial(random, depth - 1); };
    switch (random.below(7)) {
    case 0:
        return fmt::format("({} + {})", part(), part());
    case 1:
        return fmt::format("({} - {})", part(), part());
    case 2:
        return fmt::format("(-{})", part());
    case 3:
        return fmt::format("({})^2", part());
    case 4:
        return fmt::format("({})/3", part());
    case 5:
        return fmt::format("(0.7*{})", part());
    default:
        return fmt::format("({}*{})", part(), part());
    }
}

// Coefficients of a coordinate's model, as the shaders have them; and of F's.
constexpr int vectors_of_model = 3;
using Coefficients = std::array<float, 4 * vectors_of_model>;
struct Inputs {
    std::array<Coefficients, 3> coordinates;
};

struct Kind {
    const char *name, *file;
    // GLSL that turns three vectors into a model, and back.
    const char* unpacked;
    const char* packed;
};

constexpr Kind block{"block", "models/block.glsl", "md_model(a.x, a.yzw, b.xyz, c.xyz, b.w, c.w)",
                     "first = vec4(f.c, f.l); second = vec4(f.d, f.error); third = vec4(f.o, "
                     "f.slope_error);"};
constexpr Kind ray{"ray", "models/ray.glsl", "Model(a.xyz, b.xyz, a.w, b.w)",
                   "first = vec4(f.c, f.error); second = vec4(f.aside, f.slope_error); third = "
                   "vec4(0.0);"};

constexpr Kind turning_ray{"turning ray", "models/turning_ray.glsl",
                           "Model(a.xyz, b.xyz, c.xyz, a.w, b.w)",
                           "first = vec4(f.c, f.error); second = vec4(f.aside, f.slope_error); "
                           "third = vec4(f.turn, 0.0);"};

constexpr std::array kinds{&block, &ray, &turning_ray};

std::string shader(const formula::Field& field, const FieldStorage& storage, const Kind& kind) {
    ShaderText text;
    add_enclosures(text, field, storage, {});
    text.file("models/errors.glsl");
    text.file("models/point.glsl");
    if (std::string_view(kind.name) == "block") {
        // It has a sum of its own.
        ShaderText other;
        add_enclosures(other, field, storage, {});
        other.file("models/errors.glsl");
        text = std::move(other);
    }
    text.file(kind.file);
    text.file_again("models/operations.glsl");
    text.generated("F", formula::glsl_value_model(field, "Model"));
    text.generated("models a pixel", fmt::format(R"(
uniform sampler2D coordinates;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;
layout(location = 2) out vec4 third;

Model coordinate(int k) {{
    ivec2 at = ivec2(9 * int(gl_FragCoord.x) + 3 * k, int(gl_FragCoord.y));
    vec4 a = texelFetch(coordinates, at, 0);
    vec4 b = texelFetch(coordinates, at + ivec2(1, 0), 0);
    vec4 c = texelFetch(coordinates, at + ivec2(2, 0), 0);
    return {};
}}

void main() {{
    Model f = field_model(coordinate(0), coordinate(1), coordinate(2));
    {}
}}
)",
                                                 kind.unpacked, kind.packed));
    return text.text();
}

std::vector<Coefficients> on_gpu(const formula::Field& field, const Kind& kind,
                                 const std::vector<Inputs>& inputs) {
    use_shaders_of_source_tree();
    const FieldStorage storage = field_storage(field, 0, {});
    const gpu::Program program(gpu::fullscreen_vertex, shader(field, storage, kind), kind.name);
    const int width = 32, height = int(inputs.size()) / width;
    std::vector<float> texels;
    for (const Inputs& one : inputs) {
        for (const Coefficients& of : one.coordinates)
            texels.insert(texels.end(), of.begin(), of.end());
    }
    const gpu::Texture texture(gpu::Format::rgba32f, 9 * width, height, texels);
    const gpu::Target target(width, height, vectors_of_model);
    const gpu::UniformBuffer parameters(16);
    parameters.bind(0);
    program.bind_block("Parameters", 0);
    texture.bind(0);
    program.bind_sampler("coordinates", 0);
    target.bind();
    program.use();
    gpu::Fullscreen().draw();
    std::vector<Coefficients> results(inputs.size());
    for (int part = 0; part < vectors_of_model; ++part) {
        const auto pixels = target.read(part, 0, 0, width, height);
        for (std::size_t k = 0; k < results.size(); ++k) {
            std::copy_n(&pixels[4 * k], 4, &results[k][std::size_t(4 * part)]);
        }
    }
    return results;
}

// A number and its slope in s.
struct Along {
    double value = 0, slope = 0;
};

// A linear function of s that comes to no more than 1 within [-1, 1].
struct Line {
    double at_0 = 0, slope = 0;
    explicit Line(Random& random)
        : at_0(random.in(-1, 1))
        , slope((random.below(2) ? 1 : random.in(-1, 1)) * (1 - std::abs(at_0))) {}
    double at(double s) const { return at_0 + s * slope; }
};

// A place within models, and what float32 may add there.
struct Place {
    explicit Place(Random& random)
        : u(end(random))
        , v(end(random))
        , s(end(random))
        , points{Line(random), Line(random), Line(random)} {}
    double u, v, s;
    std::array<Line, 3> points;

private:
    static double end(Random& random) {
        return random.below(3) == 0 ? double(2 * random.below(2) - 1) : random.in(-1, 1);
    }
};

// The model itself.
Along of_block(const Coefficients& a, const Place& p) {
    const auto c = [&](std::size_t k) { return double(a[k]); };
    return {c(0) + c(1) * p.u + c(2) * p.v + c(3) * p.s + c(4) * p.u * p.u + c(5) * p.v * p.v +
                c(6) * p.s * p.s + c(8) * p.u * p.v + c(9) * p.u * p.s + c(10) * p.v * p.s,
            c(3) + 2 * c(6) * p.s + c(9) * p.u + c(10) * p.v};
}

Along of_ray(const Coefficients& a, const Place& p) {
    const auto c = [&](std::size_t k) { return double(a[k]); };
    Along all{c(0) + p.s * (c(1) + p.s * c(2)), c(1) + 2 * c(2) * p.s};
    for (std::size_t k = 0; k < 3; ++k) {
        const double by = p.points[k].at(p.s), turn = c(8 + k); // 0 where rays don't turn
        all.value += by * (c(4 + k) + p.s * turn);
        all.slope += p.points[k].slope * (c(4 + k) + p.s * turn) + by * turn;
    }
    return all;
}

// Where in the coefficients errors are, of the value and of the slope.
struct Errors {
    std::size_t value, slope;
};

class Models : public gpu::EveryBackend {
protected:
    // Draws the inputs of a piece that is `size` long.
    static Inputs inputs(Random& random, double size, const Kind& kind) {
        Inputs all{};
        for (Coefficients& a : all.coordinates) {
            const auto draw = [&](double most) { return float(most * random.in(-1, 1)); };
            const auto error = float(1e-6 * random.in(0, 1));
            if (&kind == &block) {
                a = {draw(1.3), draw(size), draw(size), draw(size)};
                for (const std::size_t k : {4u, 5u, 6u, 8u, 9u, 10u})
                    a[k] = draw(0.3 * size * size);
                a[7] = a[11] = error;
            } else {
                a = {draw(1.3), draw(size), draw(0.3 * size * size), error};
                for (const std::size_t k : {4u, 5u, 6u}) a[k] = draw(1e-3 * size);
                const double turn = &kind == &turning_ray ? 1e-4 * size : 0;
                for (const std::size_t k : {8u, 9u, 10u}) a[k] = draw(turn);
                a[7] = error;
            }
        }
        return all;
    }

    // Expects what models tell of F, and returns how many times the largest that F was seen to be
    // off them they allow, in the mean.
    static double hold(Random& random, const std::string& text, const Kind& kind,
                       const std::vector<double>& sizes) {
        const bool is_block = &kind == &block;
        const Errors errors = is_block ? Errors{7, 11} : Errors{3, 7};
        const auto of_model = is_block ? of_block : of_ray;
        const formula::Field field = formula::make_field(text, {});
        EXPECT_GT(formula::modelled_degree(field), 0) << text;
        formula::FieldEvaluator<double> exact(field);
        const formula::Bindings<double> nothing;
        std::vector<Inputs> all;
        for (std::size_t k = 0; k < 96; ++k) {
            all.push_back(inputs(random, sizes[k % sizes.size()], kind));
        }
        const std::vector<Coefficients> models = on_gpu(field, kind, all);
        double logarithms = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const auto allowed = double(models[k][errors.value]);
            const auto steep = double(models[k][errors.slope]);
            double largest = 1e-30;
            for (int draw = 0; draw < 60; ++draw) {
                const Place place(random);
                std::array<double, 3> p{}, d{};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const Coefficients& a = all[k].coordinates[axis];
                    const Line off(random);
                    const auto most = double(a[errors.value]);
                    const Along at = of_model(a, place);
                    p[axis] = at.value + most * off.at(place.s);
                    d[axis] = at.slope + most * off.slope;
                }
                const auto f = exact.directional(nothing, p, d);
                const Along told = of_model(models[k], place);
                // What doubles lose.
                const double lost = 1e-11 * (1 + std::abs(f[0]) + std::abs(f[1]));
                largest = std::max(largest, std::abs(f[0] - told.value));
                EXPECT_LE(std::abs(f[0] - told.value), allowed + lost) << kind.name << ' ' << text;
                EXPECT_LE(std::abs(f[1] - told.slope), steep + lost) << kind.name << ' ' << text;
            }
            logarithms += std::log(allowed / largest);
        }
        return std::exp(logarithms / double(all.size()));
    }
};
ISOMOTION_ON_EVERY_BACKEND(Models);

TEST_P(Models, FIsOffThemByNoMoreThanTheyTell) {
    Random random;
    for (int k = 0; k < 8 && !HasFailure(); ++k) {
        const std::string text = polynomial(random, 4) + " + x*y*z";
        for (const Kind* kind : kinds) hold(random, text, *kind, {0.3, 0.01, 1e-5});
    }
    for (const char* text : {"chebyshev(14, x) + chebyshev(7, y) + z", "chebyshev(50, x) + y + z",
                             "((x^2 + y^2 + z^2 - 1)^2*x - 0.1*y^3)^2 - 1e-3"}) {
        for (const Kind* kind : kinds) hold(random, text, *kind, {0.01});
    }
}

// Else nothing would be proved by them.
TEST_P(Models, AllowLittleMoreThanFIsOff) {
    Random random;
    for (const Kind* kind : kinds) {
        EXPECT_LT(hold(random, "(x^2 + y^2 + z^2 + 0.3)^3 - x^2*z^3 - y*z + x", *kind, {0.02}), 30);
    }
}

TEST(ModelledDegree, IsOfPolynomialsAlone) {
    const auto degree = [](const char* text) {
        return formula::modelled_degree(formula::make_field(text, {}));
    };
    EXPECT_EQ(degree("x^2*y + z"), 3);
    EXPECT_EQ(degree("chebyshev(50, x) + y"), 50);
    EXPECT_EQ(degree("x/3 - y"), 1);
    EXPECT_EQ(degree("cos(14*acos(max(-1, min(1, x))))*cosh(14*log(max(1, abs(x)) + "
                     "sqrt((max(1, abs(x)) - 1)*(max(1, abs(x)) + 1)))) + y"),
              14);
    EXPECT_EQ(degree("cos(14*acos(x)) + y"), 0) << "acos takes what is beyond 1 for 1";
    EXPECT_EQ(degree("exp(x)"), 0);
    EXPECT_EQ(degree("abs(x) + y"), 0);
    EXPECT_EQ(degree("1/x"), 0);
    EXPECT_EQ(degree("x^100"), 0);
}

} // namespace
} // namespace isomotion::shader::model_on_gpu_test
