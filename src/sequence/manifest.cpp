#include "sequence/manifest.h"

#include <span>
#include <string_view>

#include <fmt/format.h>

#include "base/extension.h"
#include "base/file.h"
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
    const std::string stem = name.stem();
    const std::string extension = base::lower_extension(name.path(1));
    return name.folder() / fmt::format("{}{}.manifest", stem.empty() ? "frames" : stem,
                                       extension == ".png" ? "" : extension);
}

fs::path sequence_file(const fs::path& manifest) { return manifest / "sequence.json"; }

fs::path frame_file(const fs::path& manifest, int frame) {
    return manifest / fmt::format("{:04}.json", frame);
}

Sequence read_sequence(const fs::path& manifest) {
    const fs::path file = sequence_file(manifest);
    return parse_sequence(read_text(file), file.string());
}

std::optional<FrameRecord> find_record(const fs::path& manifest, int frame) {
    const fs::path file = frame_file(manifest, frame);
    try {
        FrameRecord record = parse_frame_record(read_text(file), file.string());
        if (record.frame == frame) return record;
    } catch (const base::FileError&) { // there is none
    } catch (const ManifestError&) {   // or nothing that could be trusted
    }
    return {};
}

} // namespace isomotion::sequence
