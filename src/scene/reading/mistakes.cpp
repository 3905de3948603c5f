#include "scene/reading/mistakes.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

constexpr std::size_t most_told = 20;

std::string text_of(const std::vector<ToldMistake>& told) {
    std::vector<std::string> messages;
    std::ranges::transform(told, std::back_inserter(messages), &ToldMistake::message);
    return fmt::format("{}", fmt::join(messages, "\n"));
}

std::vector<ToldMistake> by_line(std::vector<ToldMistake> told) {
    std::ranges::stable_sort(told, {}, &ToldMistake::line);
    return told;
}

bool has_text(const toml::node& node) {
    if (const toml::table* table = node.as_table())
        return std::any_of(table->begin(), table->end(),
                           [](const auto& entry) { return has_text(entry.second); });
    if (const toml::array* array = node.as_array())
        return std::any_of(array->begin(), array->end(), has_text);
    return node.is_string();
}

} // namespace

PlacedError::PlacedError(const toml::node& at, const std::string& message)
    : SceneError(message)
    , line_(at.source().begin.line)
    , may_name_others_(at.is_table() || has_text(at)) {}

Mistakes::Mistakes(std::vector<ToldMistake> told)
    : SceneError(text_of(by_line(told)))
    , told_(by_line(std::move(told))) {}

Mistakes joined(const Mistakes& a, const Mistakes& b) {
    std::vector<ToldMistake> told = a.told();
    std::ranges::copy_if(b.told(), std::back_inserter(told), [&](const ToldMistake& mistake) {
        return std::ranges::count(a.told(), mistake) == 0;
    });
    if (told.size() > most_told) told.resize(most_told);
    return Mistakes(std::move(told));
}

void MistakeList::tell(const PlacedError& mistake) {
    may_name_others_ |= mistake.may_name_others();
    const ToldMistake told{mistake.line(), mistake.what()};
    if (!is_full() && !std::ranges::count(told_, told)) told_.push_back(told);
}

bool MistakeList::is_full() const { return told_.size() >= most_told; }

std::optional<Mistakes> MistakeList::all() const {
    return told_.empty() ? std::nullopt : std::optional(Mistakes(told_));
}

void MistakeList::throw_if_any() const {
    if (!told_.empty()) throw Mistakes(told_);
}

} // namespace isomotion::scene
