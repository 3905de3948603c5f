#include "scenes/statement.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"
#include "formula/graph/program.h"

namespace isomotion::scenes {

Statement::Statement(const std::string& text, const std::string& let,
                     const std::vector<std::string>& names)
    : text_(text) {
    const std::size_t begin = text.find_first_of("=<>!");
    if (begin == text.npos)
        throw std::invalid_argument(text + ": write a relation, \"left = right\"");
    const std::size_t end = std::min(text.find_first_not_of("=<>!", begin), text.size());
    relation_ = text.substr(begin, end - begin);
    if (relation_ != "=" && relation_ != "<" && relation_ != ">" && relation_ != "<=" &&
        relation_ != ">=" && relation_ != "!=")
        throw std::invalid_argument(text + ": the relations are = != < > <= >=");
    formula::Vocabulary vocabulary;
    vocabulary.inputs = names;
    formula::Graph graph;
    std::vector<formula::NodeId> roots;
    for (const std::string& side : {text.substr(0, begin), text.substr(end)})
        roots.push_back(formula::parse(let + side, vocabulary, graph));
    sides_.emplace(formula::schedule(graph, formula::lower(graph, roots)));
}

bool Statement::holds(std::span<const double> values, double within) {
    std::array<double, 2> sides{};
    sides_->point({}, values, sides);
    left_ = sides[0];
    right_ = sides[1];
    const double difference = left_ - right_;
    const bool equal = left_ == right_ || std::abs(difference) <= within;
    if (relation_ == "=") return equal;
    if (relation_ == "!=") return !equal && !std::isnan(difference);
    if (relation_ == "<=") return equal || difference < 0;
    if (relation_ == ">=") return equal || difference > 0;
    return relation_ == "<" ? difference < 0 : difference > 0;
}

std::string Statement::told() const { return fmt::format("{}: {} and {}", text_, left_, right_); }

} // namespace isomotion::scenes
