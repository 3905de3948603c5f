#include "sequence/names/sequence_name.h"

#include <algorithm>
#include <charconv>
#include <regex>

#include <fmt/format.h>

#include "base/input_error.h"

namespace isomotion::sequence {

SequenceName SequenceName::parse(std::string_view text) {
    const std::filesystem::path whole(text);
    const std::string file = whole.filename().string();
    if (file.empty() || file == "." || file == "..")
        throw base::InputError(
            fmt::format("{}: names a folder; a file's name belongs here, such as "
                        "frame.####.exr",
                        text));

    SequenceName name;
    name.folder_ = whole.parent_path();
    name.before_ = file;

    static const std::regex place("#+|%(0[0-9]{1,2})?d");
    std::sregex_iterator match(file.begin(), file.end(), place);
    if (match == std::sregex_iterator()) return name;

    name.has_place_ = true;
    name.before_ = match->prefix();
    name.after_ = match->suffix();
    name.digits_ = match->str().front() == '#' ? int(match->length())
                   : (*match)[1].matched       ? std::stoi((*match)[1])
                                               : 1;
    if (++match != std::sregex_iterator())
        throw base::InputError(
            fmt::format("{}: has two places for the frame's number; one run of # or "
                        "one %04d is right",
                        text));
    return name;
}

std::filesystem::path SequenceName::path(int frame) const {
    if (!has_place_) return folder_ / before_;
    return folder_ / fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

std::optional<int> SequenceName::frame_of(const std::string& file) const {
    if (!has_place_ || file.size() <= before_.size() + after_.size()) return {};
    if (!file.starts_with(before_) || !file.ends_with(after_)) return {};
    const char* const end = file.data() + file.size() - after_.size();
    int frame = 0;
    const auto [parsed, error] = std::from_chars(file.data() + before_.size(), end, frame);
    if (error != std::errc{} || parsed != end) return {};
    // Among the spellings of a number only one is a frame's.
    if (path(frame).filename().string() != file) return {};
    return frame;
}

std::string SequenceName::pattern() const {
    return before_ + std::string(std::size_t(digits_), '#') + after_;
}

std::string SequenceName::stem() const {
    std::string stem = before_;
    if (has_place_ && stem.ends_with('.')) stem.pop_back();
    stem += after_;
    const std::string extension = std::filesystem::path("." + before_ + after_).extension();
    stem.resize(stem.size() - std::min(stem.size(), extension.size()));
    return stem;
}

void SequenceName::check_holds(std::size_t frames) const {
    if (frames < 2 || has_place_) return;
    const std::filesystem::path file(before_);
    throw base::InputError(fmt::format(
        "{}: names one file for {} frames; put #### where their number "
        "goes, as in {}.####{}",
        (folder_ / file).string(), frames, file.stem().string(), file.extension().string()));
}

} // namespace isomotion::sequence
