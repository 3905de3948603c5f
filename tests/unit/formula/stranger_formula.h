// Formulas as strangers write them: every function that the language has, poles, jumps, kinks, ends
// of domains and cuts included, in trees of some depth. Unlike random_formula.h they are a text
// only: what they are compared with is their own evaluation.
#pragma once

#include <string>

#include <fmt/format.h>

#include "formula/graph/functions.h"
#include "unit/formula/testing.h"

namespace isomotion::formula {

class StrangerFormula {
public:
    explicit StrangerFormula(std::uint64_t seed)
        : random_(seed) {}

    // A formula in x, y and z of depth 2 to 4. Most have a surface in a sphere of radius 1.5 about
    // the origin.
    std::string text() { return text(2 + random_.below(3)); }
    std::string text(int depth) {
        const std::string body = part(depth);
        switch (random_.below(4)) {
        case 0:
            return fmt::format("{} + {}", body, sheet());
        case 1:
            return fmt::format("min({}, {})", body, ball());
        case 2:
            return fmt::format("max({}, {})", ball(), body);
        default:
            return fmt::format("{} - {:.3f}", body, random_.in(-0.6, 0.6));
        }
    }

private:
    std::string number() { return fmt::format("{:.3f}", random_.in(-2, 2)); }
    std::string coordinate() { return std::string(1, "xyz"[random_.below(3)]); }

    std::string ball() {
        return fmt::format("((x - {})^2 + (y - {})^2 + z^2 - {:.3f})", number(), number(),
                           random_.in(0.1, 1.5));
    }
    std::string sheet() {
        return fmt::format("({:.3f}*x + {:.3f}*y + {:.3f}*z + {:.3f})", random_.in(-3, 3),
                           random_.in(-3, 3), random_.in(-3, 3), random_.in(-1, 1));
    }

    std::string leaf() {
        switch (random_.below(4)) {
        case 0:
            return fmt::format("({:.2f}*{} + {})", random_.in(-8, 8), coordinate(), number());
        case 1:
            return sheet();
        case 2:
            return ball();
        default:
            return coordinate();
        }
    }

    std::string part(int depth) {
        if (depth == 0) return leaf();
        const std::string a = part(depth - 1);
        const auto with = [&](const char* operation) {
            return fmt::format(fmt::runtime(operation), a, part(depth - 1 - random_.below(depth)));
        };
        switch (random_.below(15)) {
        case 0:
            return with("({} + {})");
        case 1:
            return with("({} - {})");
        case 2:
            return with("{}*{}");
        case 3:
            return with("{}/({})");
        case 4:
            return with("min({}, {})");
        case 5:
            return with("max({}, {})");
        case 6:
            return with("smoothmin({}, {}, 0.3)");
        case 7:
            return fmt::format("({})^{}", a, powers[random_.below(int(std::size(powers)))]);
        case 8:
            return with("atan2({}, {})");
        case 9:
            return fmt::format("cos({}*{})", 1 + random_.below(6), with("atan2({}, {})"));
        case 10:
            return fmt::format("chebyshev({}, {})", 2 + random_.below(random_.below(4) ? 6 : 40),
                               a);
        default:
            return fmt::format("{}({})", unary(), a);
        }
    }

    std::string_view unary() {
        std::size_t count = 0;
        while (functions()[count].has_value) ++count; // those of one argument come first
        return functions()[std::size_t(random_.below(int(count)))].name;
    }

    static constexpr const char* powers[]{"2",   "3",    "-1",  "-2",     "-3",     "0.5", "1.5",
                                          "0.3", "-0.5", "2.7", "(-301)", "(-300)", "30",  "y"};

    Random random_;
};

} // namespace isomotion::formula
