// Splits POV-Ray's scene description language into words.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isomotion::scene {

struct PovWord {
    enum class Kind { name, number, text, sign, end };

    Kind kind{};
    std::string text; // "sphere", "0.5", "{"; for a directive "#declare"
    double number = 0;
    std::size_t line = 0; // counted from 0

    bool is(std::string_view what) const { return text == what && kind != Kind::text; }
};

// All words of a file, without its comments; the last one is the end. Throws SceneError.
std::vector<PovWord> pov_words(std::string_view text, const std::filesystem::path& file);

// A reader's position among the words. Reports errors with file and line.
class PovCursor {
public:
    PovCursor(const std::vector<PovWord>& words, const std::filesystem::path& file)
        : words_(&words)
        , file_(&file) {}

    const PovWord& now() const { return (*words_)[at_]; }
    const PovWord& next() const { return (*words_)[at_ + 1 < words_->size() ? at_ + 1 : at_]; }
    bool at_end() const { return now().kind == PovWord::Kind::end; }
    PovWord take();
    bool take_if(std::string_view what);
    // `for_what` names the context in messages: "sphere".
    void expect(std::string_view what, std::string_view for_what);
    // Skips from an opening brace, bracket or parenthesis to after the matching one.
    void skip_group(std::string_view for_what);

    std::size_t place() const { return at_; }
    void go_to(std::size_t place) { at_ = place; }

    [[noreturn]] void fail(std::string_view key, std::string_view message) const;
    // The same in another line, counted from 0.
    [[noreturn]] void fail_in(std::size_t line, std::string_view key,
                              std::string_view message) const;

private:
    const std::vector<PovWord>* words_;
    const std::filesystem::path* file_;
    std::size_t at_ = 0;
};

// Names that a message looks through for the one that was meant. A file may have thousands of names
// and of declarations that fail, each with a message that nobody may ever read.
inline constexpr std::size_t most_pov_names = 300;

// Counts what is being read within what.
class PovDepth {
public:
    static constexpr int most = 60;

    PovDepth(int& depth, const PovCursor& at, std::string_view key,
             std::string_view what = "parentheses and calls");
    ~PovDepth() { --depth_; }
    PovDepth(const PovDepth&) = delete;
    PovDepth& operator=(const PovDepth&) = delete;

private:
    int& depth_;
};

} // namespace isomotion::scene
