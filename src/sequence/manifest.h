// The manifest of a sequence: a folder beside the frames with `sequence.json`, a file for each
// frame (`0012.json`), and `writers`, which those who render hold a lock on.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "sequence/names/sequence_name.h"
#include "sequence/record.h"

namespace isomotion::sequence {

// Of out/name.####.png it is out/name.manifest; other formats, which may lie beside it, show in the
// name: out/name.exr.manifest. Of a name without a place for the frame's number there is none.
std::filesystem::path manifest_folder(const SequenceName& name);

std::filesystem::path sequence_file(const std::filesystem::path& manifest);
std::filesystem::path frame_file(const std::filesystem::path& manifest, int frame);

// Throws FileError if there is no such file, ManifestError with the file's name if it is no
// manifest.
Sequence read_sequence(const std::filesystem::path& manifest);

// None if there is no record of this frame, or none that can be read.
std::optional<FrameRecord> find_record(const std::filesystem::path& manifest, int frame);

} // namespace isomotion::sequence
