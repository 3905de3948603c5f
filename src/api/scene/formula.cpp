#include <cmath>

#include <fmt/format.h>

#include "api/scene/errors.h"
#include "api/scene/formula_parts.h"
#include "formula/enclosure.h"

namespace isomotion {
namespace {

using api::with_errors;

void expect_finite(const std::string& name, double value) {
    if (std::isfinite(value)) return;
    throw Error(Error::Code::input,
                fmt::format("the parameter {} must be finite, not {}", name, value));
}

formula::Field field_of(std::string_view text, const std::map<std::string, double>& parameters) {
    formula::Vocabulary vocabulary;
    for (const auto& [name, value] : parameters) {
        if (!formula::is_identifier(name) || formula::is_reserved(name)) {
            throw Error(Error::Code::input,
                        fmt::format("'{}' cannot be the name of a parameter", name));
        }
        expect_finite(name, value);
        vocabulary.parameters.push_back(name);
    }
    return formula::make_field(text, vocabulary);
}

} // namespace

Formula::Formula(std::string_view text, std::map<std::string, double> parameters) {
    parts_ = with_errors([&] {
        auto field = std::make_shared<const formula::Field>(field_of(text, parameters));
        return std::make_shared<const Parts>(std::move(field), std::move(parameters));
    });
}

Formula Formula::with(const std::string& parameter, double value) const {
    std::map<std::string, double> parameters = parts_->parameters;
    const auto found = parameters.find(parameter);
    if (found == parameters.end()) {
        throw Error(Error::Code::input,
                    fmt::format("the formula has no parameter '{}'", parameter));
    }
    expect_finite(parameter, value);
    found->second = value;
    Formula changed = *this;
    changed.parts_ = std::make_shared<const Parts>(parts_->field, std::move(parameters));
    return changed;
}

const std::map<std::string, double>& Formula::parameters() const { return parts_->parameters; }

double Formula::value(const Point& at) const { return values(std::span(&at, 1)).front(); }

Point Formula::gradient(const Point& at) const {
    return with_errors([&] {
        Point gradient{};
        formula::Evaluator<double>(parts_->field->gradient).point(parts_->bindings, at, gradient);
        return gradient;
    });
}

std::vector<double> Formula::values(std::span<const Point> at) const {
    return with_errors([&] {
        std::array<std::vector<double>, 3> coordinates;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            coordinates[axis].reserve(at.size());
            for (const Point& point : at) coordinates[axis].push_back(point[axis]);
        }
        std::vector<double> values(at.size());
        const std::array<std::span<const double>, 3> inputs{coordinates[0], coordinates[1],
                                                            coordinates[2]};
        const std::array<std::span<double>, 1> outputs{values};
        formula::Evaluator<double>(parts_->field->value).points(parts_->bindings, inputs, outputs);
        return values;
    });
}

Interval Formula::bound(const Box& box) const {
    return with_errors([&] {
        std::array<formula::Interval, 3> sides;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [low, high] = box[axis];
            if (!(low <= high) || low == formula::infinity || high == -formula::infinity) {
                throw Error(Error::Code::input,
                            fmt::format("the box has an empty side, from {} to {}", low, high));
            }
            sides[axis] = formula::Interval(low, high);
        }
        formula::Interval value;
        formula::Evaluator<formula::Interval>(formula::value_enclosure(*parts_->field))
            .point(formula::convert<formula::Interval>(parts_->bindings), sides, {&value, 1});
        return Interval{value.lo, value.hi};
    });
}

} // namespace isomotion
