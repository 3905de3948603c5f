// An index of a vocabulary's names. It is made once for all texts that use the vocabulary, as they
// may name a thousand names a hundred thousand times.
#pragma once

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "formula/graph/vocabulary.h"

namespace isomotion::formula {

// The vocabulary must outlive this object. Among equal names the first counts.
class Names {
public:
    explicit Names(const Vocabulary& vocabulary);

    const Vocabulary& vocabulary() const { return vocabulary_; }
    std::optional<int> input(std::string_view name) const { return find(inputs_, name); }
    std::optional<int> parameter(std::string_view name) const { return find(parameters_, name); }
    std::optional<int> field(int array, std::string_view name) const {
        return find(fields_[std::size_t(array)], name);
    }

private:
    using Places = std::unordered_map<std::string_view, int>;
    static std::optional<int> find(const Places& places, std::string_view name);

    const Vocabulary& vocabulary_;
    Places inputs_, parameters_;
    std::vector<Places> fields_; // of each array
};

} // namespace isomotion::formula
