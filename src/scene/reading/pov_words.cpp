#include "scene/reading/pov_words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "base/printable.h"
#include "scene/error.h"

namespace isomotion::scene {
namespace {

using Kind = PovWord::Kind;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

class Scanner {
public:
    Scanner(std::string_view text, const std::filesystem::path& file)
        : text_(text)
        , file_(file) {}

    std::vector<PovWord> words() {
        while (skip_blanks(), at_ < text_.size()) words_.push_back(word());
        words_.push_back({Kind::end, "the end of the file", 0, line_});
        return std::move(words_);
    }

private:
    [[noreturn]] void fail(std::size_t line, const std::string& message) const {
        throw SceneError(fmt::format("{}:{}: {}", file_.string(), line + 1, message));
    }
    char at(std::size_t k) const { return k < text_.size() ? text_[k] : '\0'; }

    void skip_blanks() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '/' && at(at_ + 1) == '/') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (c == '/' && at(at_ + 1) == '*') {
                skip_comment();
            } else if (c == '\n' || std::isspace(static_cast<unsigned char>(c))) {
                line_ += c == '\n';
                ++at_;
            } else {
                return;
            }
        }
    }

    // Comments hold comments.
    void skip_comment() {
        const std::size_t begin = line_;
        int depth = 0;
        do {
            if (at_ >= text_.size()) fail(begin, "/*: this comment has no end; write */");
            const std::string_view two = text_.substr(at_, 2);
            depth += two == "/*" ? 1 : two == "*/" ? -1 : 0;
            line_ += text_[at_] == '\n';
            at_ += two == "/*" || two == "*/" ? 2 : 1;
        } while (depth > 0);
    }

    PovWord word() {
        const char c = text_[at_];
        const std::size_t begin = at_;
        if (is_letter(c) || c == '#') {
            ++at_;
            while (c == '#' && (at(at_) == ' ' || at(at_) == '\t')) ++at_;
            while (is_letter(at(at_)) || is_digit(at(at_))) ++at_;
            std::string name(text_.substr(begin, at_ - begin));
            std::erase_if(name, [](char blank) { return blank == ' ' || blank == '\t'; });
            return {Kind::name, name, 0, line_};
        }
        if (is_digit(c) || (c == '.' && is_digit(at(at_ + 1)))) return number();
        if (c == '"') {
            const std::size_t end = text_.find('"', at_ + 1);
            if (end == text_.npos) fail(line_, "\": this text has no end");
            at_ = end + 1;
            PovWord text{Kind::text, std::string(text_.substr(begin + 1, end - begin - 1)), 0,
                         line_};
            line_ += std::size_t(std::ranges::count(text.text, '\n'));
            return text;
        }
        ++at_;
        return {Kind::sign, std::string(1, c), 0, line_};
    }

    PovWord number() {
        const std::size_t begin = at_;
        while (is_digit(at(at_))) ++at_;
        if (at(at_) == '.') ++at_;
        while (is_digit(at(at_))) ++at_;
        if (at(at_) == 'e' || at(at_) == 'E') {
            const bool is_signed = at(at_ + 1) == '+' || at(at_ + 1) == '-';
            if (is_digit(at(at_ + 1 + std::size_t(is_signed)))) {
                at_ += 1 + std::size_t(is_signed);
                while (is_digit(at(at_))) ++at_;
            }
        }
        std::string text(text_.substr(begin, at_ - begin));
        const double value = std::strtod(text.c_str(), nullptr);
        if (!std::isfinite(value)) fail(line_, text + ": is too large a number");
        return {Kind::number, text, value, line_};
    }

    std::string_view text_;
    const std::filesystem::path& file_;
    std::size_t at_ = 0, line_ = 0;
    std::vector<PovWord> words_;
};

} // namespace

std::vector<PovWord> pov_words(std::string_view text, const std::filesystem::path& file) {
    return Scanner(text, file).words();
}

PovWord PovCursor::take() {
    PovWord word = now();
    if (!at_end()) ++at_;
    return word;
}

bool PovCursor::take_if(std::string_view what) {
    if (!now().is(what)) return false;
    take();
    return true;
}

void PovCursor::expect(std::string_view what, std::string_view for_what) {
    if (take_if(what)) return;
    fail(for_what, fmt::format("needs '{}' before '{}'", what, base::printable_line(now().text)));
}

void PovCursor::skip_group(std::string_view for_what) {
    int depth = 0;
    const std::size_t begin = place();
    do {
        if (at_end()) {
            go_to(begin);
            fail(for_what, "its braces do not close");
        }
        const PovWord word = take();
        if (word.kind != Kind::sign) continue;
        depth += word.text == "{" || word.text == "(" || word.text == "[";
        depth -= word.text == "}" || word.text == ")" || word.text == "]";
    } while (depth > 0);
}

void PovCursor::fail(std::string_view key, std::string_view message) const {
    fail_in(now().line, key, message);
}

void PovCursor::fail_in(std::size_t line, std::string_view key, std::string_view message) const {
    throw SceneError(fmt::format("{}:{}: {}: {}", file_->string(), line + 1,
                                 base::printable_line(std::string(key)),
                                 base::printable_line(std::string(message))));
}

PovDepth::PovDepth(int& depth, const PovCursor& at, std::string_view key, std::string_view what)
    : depth_(depth) {
    if (depth_ >= most) at.fail(key, fmt::format("more than {} {} in one another", most, what));
    ++depth_;
}

} // namespace isomotion::scene
