#include "scene/reading/far_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>

#include <fmt/format.h>

#include "probe/thresholds.h"

namespace isomotion::scene {
namespace {

// The multiple of `unit` that values are counted from; none if they are near 0, or far from one
// another.
std::optional<double> where_far(std::span<const float> values, double unit, double radius) {
    if (values.empty()) return {};
    const auto [least, most] = std::ranges::minmax(values);
    const double middle = 0.5 * (double(least) + double(most));
    if (!(std::abs(middle) > probe::far_radii * radius)) return {};
    if (!(double(most) - double(least) < std::abs(middle))) return {};
    return unit * std::round(middle / unit);
}

class Counting {
public:
    Counting(const SurfaceParts& parts, const SurfaceAt& first, double unit)
        : first_(first)
        , unit_(unit) {
        const auto own = std::ptrdiff_t(parts.own_arrays);
        far_.arrays.assign(parts.arrays.begin(), parts.arrays.begin() + own);
        far_.vocabulary = parts.vocabulary;
        far_.vocabulary.arrays.resize(parts.own_arrays);
    }

    void parameter(int index) {
        const std::string& name = far_.vocabulary.parameters[std::size_t(index)];
        if (name.find('.') != name.npos) return; // one value of all elements, which has no name
        const std::array value{first_.bindings.parameters[std::size_t(index)]};
        const auto from = where_far(value, unit_, first_.bounds.radius);
        if (!from) return;
        if (!of_parameters_) {
            of_parameters_ = far_.arrays.size();
            animation::Array& made = far_.arrays.emplace_back();
            made.name = "far parameters";
            made.count = 1;
            made.is_of_formula = true;
            far_.vocabulary.arrays.push_back({"far parameters", {}});
        }
        add({.is_parameter = true, .index = index, .from = *from}, *of_parameters_, name, value);
    }

    void element(std::size_t array, int field) {
        if (array >= far_.arrays.size() || far_.arrays[array].is_of_formula) return;
        const auto& values = first_.bindings.arrays[array].fields[std::size_t(field)];
        const auto from = where_far(values, unit_, first_.bounds.radius);
        if (!from) return;
        add({.index = int(array), .field = field, .from = *from}, array,
            far_.arrays[array].fields[std::size_t(field)].name, values);
    }

    FarNumbers all() && { return std::move(far_); }

private:
    void add(formula::FarNumber number, std::size_t array, const std::string& name,
             std::span<const float> values) {
        number.near_array = int(array);
        number.near_field = int(far_.arrays[array].fields.size());
        const std::string near = fmt::format("{} from {}", name, number.from);
        far_.arrays[array].fields.push_back(
            {near, animation::Expression{fmt::format("{} - ({})", name, number.from)}});
        far_.vocabulary.arrays[array].fields.push_back({near, {}});
        std::vector<float> column;
        for (const float value : values) column.push_back(float(double(value) - number.from));
        far_.columns.emplace_back(array, std::move(column));
        far_.numbers.push_back(number);
    }

    const SurfaceAt& first_;
    double unit_;
    FarNumbers far_;
    std::optional<std::size_t> of_parameters_;
};

} // namespace

FarNumbers far_numbers(const SurfaceParts& parts, const SurfaceAt& first, double unit) {
    Counting counting(parts, first, unit);
    std::set<std::pair<int, int>> fields;
    std::set<int> parameters;
    const formula::Graph& graph = parts.surface.field->graph;
    for (formula::NodeId id = 0; id < graph.size(); ++id) {
        const formula::Node& node = graph[id];
        if (node.op == formula::Op::parameter) parameters.insert(node.index);
        if (node.op == formula::Op::element) fields.emplace(node.index, node.second);
    }
    for (const int index : parameters) counting.parameter(index);
    for (const auto& [array, field] : fields) counting.element(std::size_t(array), field);
    return std::move(counting).all();
}

} // namespace isomotion::scene
