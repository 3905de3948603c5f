// The table of functions, and what the parser, the names and the documents make of it.
#include "formula/graph/functions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "formula/graph/composed_functions.h"
#include "formula/graph/operations.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

std::string call(const Function& function, std::size_t count, std::string_view argument) {
    std::string text = fmt::format("{}(", function.name);
    for (std::size_t k = 0; k < count; ++k)
        text += fmt::format("{}{}", k > 0 ? ", " : "", argument);
    return text + ")";
}

TEST(Functions, HaveDifferentNamesThatAreReservedUnlessFree) {
    std::set<std::string_view> names;
    for (const Function& function : functions()) {
        EXPECT_TRUE(names.insert(function.name).second) << function.name;
        EXPECT_EQ(is_reserved(function.name), function.naming == Naming::reserved) << function.name;
        EXPECT_EQ(find_function(function.name), &function);
    }
    EXPECT_EQ(find_function("si"), nullptr);
    EXPECT_EQ(find_function(""), nullptr);
}

TEST(Functions, TakeAsManyArgumentsAsTheyHave) {
    Vocabulary vocabulary = test_vocabulary();
    vocabulary.allows_random = true;
    std::vector<Function> all(functions().begin(), functions().end());
    all.insert(all.end(), composed_functions().begin(), composed_functions().end());
    for (const Function& function : all) {
        if (!function.call && function.name != "pow") continue; // arrays and degrees are no values
        if (function.name == "smoothstep") continue;            // from x to x it has no value
        const auto parses = [&](std::size_t count) {
            Graph graph;
            try {
                parse(call(function, count, "x"), vocabulary, graph);
                return std::string();
            } catch (const ParseError& error) {
                return error.message();
            }
        };
        EXPECT_EQ(parses(function.count), "");
        if (function.may_have_more) {
            EXPECT_EQ(parses(function.count + 1), "");
            EXPECT_EQ(parses(function.count + 7), "");
            EXPECT_EQ(parses(function.count - 1),
                      fmt::format("{} takes two or more", function.name));
            continue;
        }
        for (const std::size_t count : {std::size_t(0), function.count - 1, function.count + 1}) {
            EXPECT_THAT(parses(count), testing::StartsWith(fmt::format(
                                           "{} takes {} argument{}, not {}", function.name,
                                           function.count, function.count == 1 ? "" : "s", count)));
        }
    }
}

TEST(Functions, AreDefinedForConstantsWhereTheyHaveAValue) {
    for (const Function& function : functions()) {
        if (!function.has_value) continue;
        for (const double x : {-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0}) {
            const std::string text = fmt::format("{}({})", function.name, x);
            Graph graph;
            if (function.has_value(x)) {
                EXPECT_NO_THROW(parse(graph, text)) << text;
            } else {
                EXPECT_THROW(parse(graph, text), ParseError) << text;
            }
        }
    }
}

// Of doubles, by the table of operations.
double result_of(Op op, double x) {
    using Do = Operations<double>;
    switch (op) {
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        return Do::name(x);
        ISOMOTION_FUNCTIONS(ROW)
#undef ROW
    default:
        ADD_FAILURE() << "no function of one argument: " << int(op);
        return 0;
    }
}

constexpr std::array functions_of_one{
#define ROW(name, ...) Op::name,
    ISOMOTION_FUNCTIONS(ROW)
#undef ROW
};

// What the rows say of signs, extents and zeros, at points of every size on both sides.
TEST(Functions, HaveTheValuesThatTheirRowsSay) {
    std::vector<double> points{0};
    for (int k = -60; k <= 60; ++k) {
        for (const double sign : {-1.0, 1.0}) points.push_back(sign * std::pow(1.3, k));
    }
    constexpr double large = 1e6; // beyond what a finite function makes of the points
    for (const Op op : functions_of_one) {
        const Traits& row = *unary_traits(op);
        double most = 0;
        for (const double x : points) {
            const double f = result_of(op, x);
            const std::string where = fmt::format("{}({}) = {}", name(op), x, f);
            if (row.is_never_negative()) {
                EXPECT_GE(f, 0) << where;
            }
            if (row.sign == Sign::positive && std::abs(x) < 100) {
                EXPECT_GT(f, 0) << where;
            }
            if (row.sign == Sign::as_argument && x >= 0) {
                EXPECT_GE(f, 0) << where;
            }
            if (row.extent == Extent::unit) {
                EXPECT_LE(std::abs(f), 1) << where;
            }
            if (row.extent == Extent::finite) {
                EXPECT_LE(std::abs(f), std::abs(x) + 4) << where;
            }
            most = std::max(most, std::abs(f));
        }
        const bool has_pole = row.breaks == Breaks::pole_at_0 || row.breaks == Breaks::poles;
        if (row.extent == Extent::unbounded && !has_pole) {
            EXPECT_GT(most, large) << name(op);
        }
        if (has_pole) {
            EXPECT_EQ(row.extent, Extent::unbounded) << name(op);
        }
        EXPECT_EQ(result_of(op, 0) == 0, row.at_0 == At0::zero) << name(op);
    }
}

// Slopes to both sides of the places where a function may break.
TEST(Functions, BreakWhereTheirRowsSay) {
    constexpr double h = 1e-7;
    const auto bends_at = [](Op op, double x) {
        const double f = result_of(op, x);
        const double left = (f - result_of(op, x - h)) / h, right = (result_of(op, x + h) - f) / h;
        constexpr double of_a_jump = 1e4; // or of an upright tangent: no other is as steep here
        return !(std::abs(left - right) < 1e-3 && std::abs(left) < of_a_jump);
    };
    for (const Op op : functions_of_one) {
        const Breaks row = breaks(op);
        const bool bends_at_0 = bends_at(op, 0), bends_at_1 = bends_at(op, 1);
        EXPECT_EQ(bends_at_0,
                  row == Breaks::kink_at_0 || row == Breaks::pole_at_0 || row == Breaks::steps)
            << name(op);
        EXPECT_EQ(bends_at_1,
                  row == Breaks::kink_at_1 || row == Breaks::begins_at_1 || op == Op::floor)
            << name(op);
        EXPECT_FALSE(bends_at(op, 0.3)) << name(op);
        const bool is_flat = result_of(op, 0.3) == result_of(op, 0.4);
        EXPECT_EQ(is_flat, row == Breaks::steps || row == Breaks::begins_at_1) << name(op);
        EXPECT_EQ(has_steps(op), row == Breaks::steps) << name(op);
    }
}

double result_of(Op op, double a, double b) {
    using Do = Operations<double>;
    switch (op) {
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        return Do::name(a, b);
        ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
    default:
        ADD_FAILURE() << "no operation of two arguments: " << int(op);
        return 0;
    }
}

constexpr std::array operations_of_two{
#define ROW(name, ...) Op::name,
    ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
};

TEST(Functions, OfTwoHaveTheValuesThatTheirRowsSay) {
    std::vector<double> points{0};
    for (int k = -30; k <= 30; ++k) {
        for (const double sign : {-1.0, 1.0}) points.push_back(sign * std::pow(1.6, k));
    }
    for (const Op op : operations_of_two) {
        const Traits& row = *traits(op);
        double most = 0;
        bool is_negative = false; // of arguments that are not
        for (const double a : points) {
            for (const double b : points) {
                const double f = result_of(op, a, b);
                if (std::isnan(f)) continue;
                most = std::max(most, std::abs(f));
                const bool never =
                    row.is_never_negative([&](int k) { return (k == 0 ? a : b) >= 0; });
                if (never) {
                    EXPECT_GE(f, 0) << name(op) << ' ' << a << ' ' << b;
                }
                is_negative = is_negative || (a >= 0 && b >= 0 && f < 0);
            }
        }
        EXPECT_EQ(is_negative, op == Op::subtract) << name(op);
        const double products = 1e13; // of the largest points
        EXPECT_EQ(most > products, row.extent == Extent::unbounded) << name(op) << ' ' << most;
        EXPECT_EQ(row.arguments, 2u);
        EXPECT_EQ(unary_traits(op), nullptr);
    }
}

// Slopes beside points of each kind.
TEST(Functions, OfTwoBreakWhereTheirRowsSay) {
    constexpr double h = 1e-7;
    const auto bends = [](double before, double f, double after) {
        const double left = (f - before) / h, right = (after - f) / h;
        constexpr double of_a_jump = 1e5;
        return !(std::abs(left - right) < 1e-3 && std::abs(left) < of_a_jump);
    };
    const auto bends_at = [&](Op op, double a, double b) {
        const double f = result_of(op, a, b);
        return bends(result_of(op, a - h, b), f, result_of(op, a + h, b)) ||
               bends(result_of(op, a, b - h), f, result_of(op, a, b + h));
    };
    for (const Op op : operations_of_two) {
        const Breaks row = breaks(op);
        EXPECT_FALSE(bends_at(op, 0.3, 0.7)) << name(op);
        EXPECT_EQ(bends_at(op, 0.3, 0.3), row == Breaks::kink_where_same) << name(op);
        EXPECT_EQ(bends_at(op, 0, 0.5), row == Breaks::base_at_0) << name(op);
        EXPECT_EQ(bends_at(op, 0, -0.5),
                  row == Breaks::base_at_0 || row == Breaks::cut || row == Breaks::axis)
            << name(op);
        EXPECT_EQ(bends_at(op, 0.3, 0), row == Breaks::pole_at_b_0) << name(op);
        const bool is_rough_at_0 = row != Breaks::nowhere;
        EXPECT_EQ(bends_at(op, 0, 0), is_rough_at_0) << name(op);
    }
}

std::string read(const std::string& name) {
    std::ifstream file(ISOMOTION_SOURCE_DIR "/docs/" + name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

bool is_part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

bool has_word(const std::string& text, std::string_view word) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const bool begins = at == 0 || !is_part_of_name(text[at - 1]);
        if (begins && !is_part_of_name(text[at + word.size()])) return true;
    }
    return false;
}

// The list at the top of docs/formulas.md, and random's place in docs/scene-file.md.
TEST(Functions, AreThoseOfTheDocuments) {
    const std::string page = read("formulas.md"), scenes = read("scene-file.md");
    const auto begin = page.find("    + - * / ^"), end = page.find("\n\n`^` binds");
    ASSERT_NE(begin, std::string::npos);
    ASSERT_NE(end, std::string::npos);
    const std::string list = page.substr(begin, end - begin);
    std::vector<Function> all(functions().begin(), functions().end());
    all.insert(all.end(), composed_functions().begin(), composed_functions().end());
    for (const Function& function : all) {
        const std::string written = fmt::format("{}({})", function.name, function.arguments);
        if (function.name == "random") {
            EXPECT_NE(scenes.find(written), std::string::npos);
        } else if (function.has_value) {
            EXPECT_TRUE(has_word(list, function.name)) << function.name;
        } else {
            EXPECT_NE(list.find(written), std::string::npos) << written;
        }
    }
    // And nothing that is no function: names of the first line, and those that are called.
    std::istringstream lines(list);
    std::string line, word;
    std::getline(lines, line);
    for (std::istringstream words(line); words >> word;) {
        if (!is_part_of_name(word[0])) continue; // + - *
        EXPECT_NE(find_function(word), nullptr) << word;
    }
    while (std::getline(lines, line)) {
        const auto first = line.find_first_not_of(' ');
        if (first == std::string::npos) continue;
        const std::string name = line.substr(first, line.find('(') - first);
        EXPECT_NE(find_function(name), nullptr) << line;
    }
}

} // namespace
} // namespace isomotion::formula
