#include <regex>

#include <fmt/format.h>

#include "image/sequence.h"

namespace isomotion::image {

SequenceName SequenceName::parse(std::string_view text) {
    const std::filesystem::path whole(text);
    const std::string file = whole.filename().string();
    if (file.empty() || file == "." || file == "..")
        throw ImageError(fmt::format("{}: names a folder; a file's name belongs here, such as "
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
        throw ImageError(fmt::format("{}: has two places for the frame's number; one run of # or "
                                     "one %04d is right",
                                     text));
    return name;
}

std::filesystem::path SequenceName::path(int frame) const {
    if (!has_place_) return folder_ / before_;
    return folder_ / fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

void SequenceName::check_holds(std::size_t frames) const {
    if (frames < 2 || has_place_) return;
    const std::filesystem::path file(before_);
    throw ImageError(fmt::format("{}: names one file for {} frames; put #### where their number "
                                 "goes, as in {}.####{}",
                                 (folder_ / file).string(), frames, file.stem().string(),
                                 file.extension().string()));
}

} // namespace isomotion::image
