// What the public header gives as the head of a shader compiles and has the formula's values.
#include <array>
#include <map>
#include <string>
#include <vector>

#include "isomotion/drawing.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::gpu {
namespace {

constexpr int side = 32;

Point place_of(int column, int row) { return {float(column) / 16 - 1, float(row) / 16 - 1, 0.375}; }

class FormulaTest : public EveryBackend {};

TEST_P(FormulaTest, HasItsValuesAndGradientsInShaders) {
    for (const auto& [text, parameters] :
         std::vector<std::pair<std::string, std::map<std::string, double>>>{
             {"x^2 + 2*y^2 + z^2 - 1", {}},
             {"a*sin(3*x) + exp(b*y) - acos(z)^c + d*atan(y/(3 - x))/e",
              {{"a", 0.5}, {"b", -1.25}, {"c", 2.5}, {"d", 3}, {"e", 0.75}}},
             {"max(x, abs(y) - 0.2) + log(3 + z)*sqrt(2 + x)", {}}}) {
        SCOPED_TRACE(text);
        const Formula formula(text, parameters);
        const Program program(fullscreen_vertex,
                              glsl_of(formula) +
                                  "out vec4 result;\nvoid main() {\n"
                                  "    vec3 p = vec3((gl_FragCoord.xy - 0.5)/16.0 - 1.0, 0.375);\n"
                                  "    result = vec4(field(p), field_gradient(p));\n}\n",
                              "formula");
        std::vector<glm::vec4> values(2);
        int k = 0;
        for (const auto& [name, value] : formula.parameters()) {
            values[std::size_t(k / 4)][k % 4] = float(value);
            ++k;
        }
        values.resize(std::size_t(k + 3) / 4);
        if (k > 0) program.set("parameters", values);
        const Target target(side, side);
        target.bind();
        program.use();
        Fullscreen().draw();
        const std::vector<float> drawn = target.read(0, 0, 0, side, side);
        for (int row = 0; row < side; ++row) {
            for (int column = 0; column < side; ++column) {
                const Point place = place_of(column, row);
                const float* result = &drawn[std::size_t(4 * (row * side + column))];
                EXPECT_NEAR(double(result[0]), formula.value(place), 2e-5);
                const Point gradient = formula.gradient(place);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    EXPECT_NEAR(double(result[1 + axis]), gradient[axis], 1e-4);
            }
        }
    }
}

ISOMOTION_ON_EVERY_BACKEND(FormulaTest);

} // namespace
} // namespace isomotion::gpu
