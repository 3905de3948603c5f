// What a Formula of the public header holds.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "formula/field.h"
#include "isomotion/scene.h"

namespace isomotion {

// The field is shared by copies with other values.
struct Formula::Parts {
    std::shared_ptr<const formula::Field> field;
    std::map<std::string, double> parameters;
    formula::Bindings<double> bindings{};

    Parts(std::shared_ptr<const formula::Field> shared, std::map<std::string, double> values)
        : field(std::move(shared))
        , parameters(std::move(values)) {
        for (const auto& [name, value] : parameters) bindings.parameters.push_back(value);
    }
};

} // namespace isomotion
