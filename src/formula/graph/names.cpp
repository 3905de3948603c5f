#include "formula/graph/names.h"

namespace isomotion::formula {

Names::Names(const Vocabulary& vocabulary)
    : vocabulary_(vocabulary) {
    for (std::size_t k = 0; k < vocabulary.inputs.size(); ++k)
        inputs_.emplace(vocabulary.inputs[k], int(k));
    for (std::size_t k = 0; k < vocabulary.parameters.size(); ++k)
        parameters_.emplace(vocabulary.parameters[k], int(k));
    for (const ArrayName& array : vocabulary.arrays) {
        Places& fields = fields_.emplace_back();
        for (std::size_t f = 0; f < array.fields.size(); ++f)
            fields.emplace(array.fields[f].name, int(f));
    }
}

std::optional<int> Names::find(const Places& places, std::string_view name) {
    const auto found = places.find(name);
    if (found == places.end()) return std::nullopt;
    return found->second;
}

} // namespace isomotion::formula
