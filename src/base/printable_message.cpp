#include "base/printable_message.h"

#include <algorithm>

#include "base/printable.h"

namespace isomotion::base {
namespace {

constexpr std::size_t most_in_a_line = 1200; // lists of what is known take up to half of it

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

bool is_among(std::string_view some, std::string_view text, std::size_t k) {
    return k >= text.size() || some.find(text[k]) != some.npos;
}

// The place of the quote that ends what the one at `begin` begins, or npos.
std::size_t end_of_quoted(std::string_view line, std::size_t begin) {
    for (std::size_t k = begin + 1; k < line.size(); ++k) {
        if (line[k] == line[begin] && is_among(" ,;:.)", line, k + 1)) return k;
    }
    return line.npos;
}

// With each word shortened, and each part of a path: no word of ours is that long.
std::string with_short_words(std::string_view line) {
    constexpr std::string_view between = " /";
    std::string result;
    while (!line.empty()) {
        const std::size_t word = std::min(line.find_first_of(between), line.size());
        result += shortened(line.substr(0, word));
        const std::size_t next = std::min(line.find_first_not_of(between, word), line.size());
        result += line.substr(word, next - word);
        line.remove_prefix(next);
    }
    return result;
}

std::string message_line(std::string_view line) {
    if (line.size() <= most_repeated) return std::string(line);
    std::string result, quotes = "'\"";
    for (std::size_t k = 0; k < line.size();) {
        const bool begins =
            quotes.find(line[k]) != quotes.npos && (k == 0 || is_among(" (", line, k - 1));
        const std::size_t end = begins ? end_of_quoted(line, k) : line.npos;
        if (end == line.npos) {
            if (begins) std::erase(quotes, line[k]); // none further on is ended either
            result += line[k++];
        } else {
            result += line[k];
            result += shortened(line.substr(k + 1, end - k - 1));
            result += line[end];
            k = end + 1;
        }
    }
    return shortened(with_short_words(result), most_in_a_line);
}

} // namespace

std::string shortened(std::string_view text, std::size_t most) {
    constexpr std::string_view gap = "...";
    if (text.size() <= most) return std::string(text);
    std::size_t front = (most - gap.size()) * 3 / 4;
    std::size_t back = text.size() - (most - gap.size() - front);
    while (front > 0 && continues(text[front])) --front;
    while (back < text.size() && continues(text[back])) ++back;
    return std::string(text.substr(0, front)).append(gap).append(text.substr(back));
}

std::string printable_message(std::string_view text) {
    const std::string shown = printable(text);
    std::string result;
    for (std::string_view rest = shown;;) {
        const std::size_t end = rest.find('\n');
        result += message_line(rest.substr(0, end));
        if (end == rest.npos) return result;
        result += '\n';
        rest.remove_prefix(end + 1);
    }
}

} // namespace isomotion::base
