#include "sequence/names/sequence_name.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "base/input_error.h"
#include "base/printable.h"

namespace isomotion::sequence {
namespace {

constexpr std::size_t most_digits = 32;

struct Place {
    std::size_t begin = std::string::npos, end = std::string::npos;
    std::size_t digits = 0;
};

// `####`, `%d` or `%04d`, from `begin` on.
Place find_place(std::string_view text, std::size_t begin) {
    const auto is_digit = [&](std::size_t k) {
        return k < text.size() && '0' <= text[k] && text[k] <= '9';
    };
    for (std::size_t k = begin; k < text.size(); ++k) {
        if (text[k] == '#') {
            const std::size_t end = std::min(text.find_first_not_of('#', k), text.size());
            return {k, end, end - k};
        }
        if (text[k] != '%') continue;
        std::size_t end = k + 1, digits = 1;
        if (end < text.size() && text[end] == '0' && is_digit(end + 1)) {
            digits = 0;
            for (++end; is_digit(end); ++end)
                digits = std::min(10 * digits + std::size_t(text[end] - '0'), most_digits + 1);
        }
        if (end < text.size() && text[end] == 'd') return {k, end + 1, digits};
    }
    return {};
}

} // namespace

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

    const Place place = find_place(file, 0);
    if (place.begin == std::string::npos) return name;

    name.has_place_ = true;
    name.before_ = file.substr(0, place.begin);
    name.after_ = file.substr(place.end);
    name.digits_ = int(std::min(std::max(place.digits, std::size_t(1)), most_digits));
    if (find_place(file, place.end).begin != std::string::npos)
        throw base::InputError(
            fmt::format("{}: has two places for the frame's number; one run of # or "
                        "one %04d is right",
                        base::printable_line(text)));
    if (place.digits > most_digits)
        throw base::InputError(fmt::format("{}: the frame's number has at most {} digits",
                                           base::printable(text.substr(0, 60)), most_digits));
    if (!base::is_one_printable_line(file))
        throw base::InputError(
            fmt::format("{}: a sequence's name must be UTF-8 that can be printed, as its manifest "
                        "holds it",
                        base::printable_line(text)));
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

std::string stem_of_frames(const std::string& name) {
    std::string stem = name;
    for (Place place = find_place(stem, 0); place.begin != std::string::npos;
         place = find_place(stem, place.end)) {
        const auto begin = stem.begin() + std::ptrdiff_t(place.begin);
        const auto end = stem.begin() + std::ptrdiff_t(place.end);
        std::replace(begin, end, '#', '_');
        std::replace(begin, end, '%', '_');
    }
    return base::is_one_printable_line(stem) ? stem : base::printable_line(stem);
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
