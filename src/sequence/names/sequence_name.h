// The names of a sequence's files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace isomotion::sequence {

// The name of a sequence of files: `out/name.####.exr` or `out/name.%04d.exr`, with one place for
// the frame's number in the last part; or a name without a place, for one frame.
class SequenceName {
public:
    // Throws an InputError for a folder, for more than one place or more than 32 digits, and for a
    // sequence whose name is not printable UTF-8, since manifests contain it.
    static SequenceName parse(std::string_view text);

    // The file of a frame: the number padded with zeros, with more digits if needed.
    std::filesystem::path path(int frame) const;

    // The frame whose path() has that last part, or none.
    std::optional<int> frame_of(const std::string& file) const;

    const std::filesystem::path& folder() const { return folder_; }
    // The last part as `name.####.exr`, however the place was written.
    std::string pattern() const;
    // The last part without the place, the extension and the dots before these: `name`; empty if
    // nothing is left.
    std::string stem() const;

    bool holds_many() const { return has_place_; }

    // Throws an InputError if the name has no place for the numbers of that many frames.
    void check_holds(std::size_t frames) const;

private:
    std::filesystem::path folder_;
    std::string before_;
    std::string after_;
    int digits_ = 0;
    bool has_place_ = false;
};

// A scene's name as the stem of file names: `_` replaces `#` and `%` where they would be places for
// a number, and U+FFFD replaces bytes that a sequence's name can't have.
std::string stem_of_frames(const std::string& name);

} // namespace isomotion::sequence
