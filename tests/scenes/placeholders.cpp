#include "scenes/placeholders.h"

#include <charconv>
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

std::string with_values(std::string text, const Values& values) {
    constexpr int most = 10'000; // of a value that holds itself
    int replaced = 0;
    for (std::size_t open = text.rfind('{'); open != text.npos;) {
        const std::size_t close = text.find('}', open);
        if (close != text.npos) {
            const std::string inside = text.substr(open + 1, close - open - 1);
            const auto value = values.find(inside);
            if (value != values.end() || inside.starts_with('=')) {
                if (++replaced > most) throw std::invalid_argument("{" + inside + "} has no end");
                const std::string by = value != values.end()
                                           ? value->second
                                           : fmt::format("{}", number_of(inside.substr(1), values));
                text.replace(open, close - open + 1, by);
                // A value may hold further places, and the place may be part of a name.
                open = text.rfind('{', open + by.size());
                continue;
            }
        }
        open = open == 0 ? text.npos : text.rfind('{', open - 1);
    }
    return text;
}

} // namespace isomotion::scenes
