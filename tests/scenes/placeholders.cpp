#include "scenes/placeholders.h"

#include <charconv>
#include <optional>
#include <regex>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"

namespace isomotion::scenes {

double number_of(const std::string& expression, const Values& values) {
    formula::Vocabulary names;
    std::vector<double> numbers;
    for (const auto& [name, value] : values) {
        double number = 0;
        const auto [end, error] =
            std::from_chars(value.data(), value.data() + value.size(), number);
        if (error != std::errc{} || end != value.data() + value.size()) continue;
        names.inputs.push_back(name);
        numbers.push_back(number);
    }
    formula::Graph graph;
    const formula::NodeId root = formula::parse(expression, names, graph);
    double result = 0;
    formula::Evaluator<double>(formula::schedule_lowered(graph, root))
        .point({}, numbers, std::span(&result, 1));
    return result;
}

namespace {

std::string repeated(const std::smatch& times) {
    std::string all;
    for (int k = 1; k <= std::stoi(times[1]); ++k)
        all += std::regex_replace(times[3].str(), std::regex("<" + times[2].str() + ">"),
                                  std::to_string(k));
    return all;
}

// What stands for what is in braces, if anything does.
std::optional<std::string> value_of(const std::string& inside, const Values& values) {
    static const std::regex times("(\\d+) times (\\w+): (.*)");
    std::smatch parts;
    if (const auto value = values.find(inside); value != values.end()) return value->second;
    if (inside.starts_with('=')) return fmt::format("{}", number_of(inside.substr(1), values));
    if (std::regex_match(inside, parts, times)) return repeated(parts);
    return std::nullopt;
}

} // namespace

std::string with_values(std::string text, const Values& values) {
    constexpr int most = 10'000; // of a value that holds itself
    int replaced = 0;
    for (std::size_t open = text.rfind('{'); open != text.npos;) {
        const std::size_t close = text.find('}', open);
        const auto by = close == text.npos
                            ? std::nullopt
                            : value_of(text.substr(open + 1, close - open - 1), values);
        if (!by) {
            open = open == 0 ? text.npos : text.rfind('{', open - 1);
            continue;
        }
        if (++replaced > most) throw std::invalid_argument("a value holds itself: " + *by);
        text.replace(open, close - open + 1, *by);
        // A value may hold further places, and the place may be part of a name.
        open = text.rfind('{', open + by->size());
    }
    return text;
}

} // namespace isomotion::scenes
