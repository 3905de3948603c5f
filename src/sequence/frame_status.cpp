#include "sequence/frame_status.h"

#include "base/file.h"

namespace isomotion::sequence {
namespace fs = std::filesystem;
namespace {

bool has_the_bytes(const fs::path& file, const FrameRecord& record) {
    std::error_code error;
    if (fs::file_size(file, error) != record.bytes || error) return false;
    try {
        return base::hash_of_file(file) == record.hash;
    } catch (const base::FileError&) {
        return false;
    }
}

} // namespace

FrameStatus frame_status(const fs::path& file, const std::optional<FrameRecord>& record,
                         std::string_view fingerprint, std::string_view version) {
    std::error_code error;
    if (!fs::exists(file, error)) return FrameStatus::missing;
    if (!record) return FrameStatus::foreign;
    if (record->fingerprint != fingerprint) {
        return record->provenance.version == version ? FrameStatus::stale : FrameStatus::outdated;
    }
    return has_the_bytes(file, *record) ? FrameStatus::whole : FrameStatus::changed;
}

} // namespace isomotion::sequence
