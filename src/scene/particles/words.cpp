#include "scene/particles/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

bool is_blank(char c) { return blanks.find(c) != blanks.npos; }

// A word as messages show it.
std::string shortened(std::string_view word) {
    constexpr std::size_t most = 60;
    return word.size() <= most ? std::string(word) : fmt::format("{}...", word.substr(0, most));
}

} // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const auto begin = text.find_first_not_of(blank);
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

Number number_of(std::string_view word) {
    double value = 0;
    // from_chars knows no leading plus.
    const bool plus = word.starts_with('+') && !word.starts_with("+-");
    const char* begin = word.data() + (plus ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (error == std::errc::result_out_of_range)
        return {0, fmt::format("'{}' is beyond the range of numbers", shortened(word))};
    if (error != std::errc() || end != word.data() + word.size())
        return {0, fmt::format("'{}' is not a number", shortened(word))};
    if (!std::isfinite(value))
        return {0, fmt::format("'{}' is not a finite number", shortened(word))};
    return {value, {}};
}

// What begins there is being read.
void Words::begin_at(std::size_t begin) {
    const auto from = text_.begin() + std::ptrdiff_t(counted_);
    line_ += int(std::count(from, text_.begin() + std::ptrdiff_t(begin), '\n'));
    counted_ = begin;
}

std::string_view Words::next() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    begin_at(begin);
    return text_.substr(begin, at_ - begin);
}

bool Words::meets(std::string_view word) {
    const std::size_t before = at_;
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (text_.substr(at_).starts_with(word)) {
        const std::size_t end = at_ + word.size();
        if (end == text_.size() || is_blank(text_[end])) {
            begin_at(at_);
            at_ = end;
            return true;
        }
    }
    at_ = before;
    return false;
}

std::string_view Words::need(std::string_view what) {
    const std::string_view word = next();
    if (word.empty()) fail(fmt::format("the file ends before {}", what));
    return word;
}

std::optional<std::string_view> Words::line_as_it_is() {
    begin_at(at_);
    if (at_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    return line;
}

std::optional<std::string_view> Words::rest_of_line() {
    const auto line = line_as_it_is();
    return line ? std::optional(trimmed(*line)) : std::nullopt;
}

std::string_view Words::take(std::size_t count, std::string_view what) {
    if (count > left()) {
        fail_at_byte(request_, at_,
                     fmt::format("the file ends in {}: it has {} bytes, of {} more that belong "
                                 "here",
                                 what, text_.size(), count));
    }
    at_ += count;
    counted_ = at_;
    return text_.substr(at_ - count, count);
}

double Words::number(std::string_view word, std::string_view column) const {
    const Number number = number_of(word);
    if (!number.wrong.empty()) fail(fmt::format("{}: {}", column, number.wrong));
    return number.value;
}

std::size_t Words::count(std::string_view what) {
    const std::string_view word = need(what);
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        fail(fmt::format("{} must be a whole number, not '{}'", what, shortened(word)));
    return value;
}

} // namespace isomotion::scene
