#include "sequence/manifest.h"

#include <algorithm>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "base/file.h"
#include "base/input_error.h"
#include "base/printable.h"
#include "sequence/manifest_json.h"

namespace isomotion::sequence {
namespace fs = std::filesystem;
namespace {

std::string read_text(const fs::path& file) {
    constexpr std::size_t most = 16 << 20; // 100,000 frames take less
    const std::vector<std::byte> bytes = base::read_whole(file, most);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

fs::path manifest_folder(const SequenceName& name) {
    constexpr std::string_view place = ".####";
    const std::string pattern = name.pattern();
    const auto begins_with_a_name = [&](std::string_view ending) {
        const std::size_t length = pattern.size() - std::min(pattern.size(), ending.size());
        return length > 0 && pattern.substr(length) == ending &&
               !pattern.substr(0, length).ends_with(".exr");
    };
    std::string folder = pattern;
    if (begins_with_a_name(".####.png")) {
        folder = pattern.substr(0, pattern.find(place));
    } else if (begins_with_a_name(".####.exr")) {
        folder = pattern.substr(0, pattern.find(place)) + ".exr";
    }
    return name.folder() / (folder + ".manifest");
}

fs::path sequence_file(const fs::path& manifest) { return manifest / "sequence.json"; }

fs::path frame_file(const fs::path& manifest, int frame) {
    return manifest / fmt::format("{:04}.json", frame);
}

Sequence read_sequence(const fs::path& manifest) {
    const fs::path file = sequence_file(manifest);
    Sequence sequence = parse_sequence(read_text(file), file.string());
    const std::string& pattern = sequence.format.pattern;
    const auto fail = [&](std::string_view what) {
        throw Error(Error::Code::file, fmt::format("{}: files: {}; this is no manifest",
                                                   base::printable(file.string()), what));
    };
    if (pattern.find('/') != std::string::npos)
        fail("must be names beside the manifest, without a folder");
    try {
        if (!SequenceName::parse(pattern).holds_many()) fail("must have a place for the frame");
    } catch (const base::InputError& error) {
        fail(error.what());
    }
    return sequence;
}

std::optional<FrameRecord> find_record(const SequenceName& name, int frame) {
    const fs::path file = frame_file(manifest_folder(name), frame);
    try {
        FrameRecord record = parse_frame_record(read_text(file), file.string());
        if (record.frame == frame && record.file == name.path(frame).filename()) return record;
    } catch (const Error&) { // there is none, or nothing that could be trusted
    }
    return {};
}

} // namespace isomotion::sequence
