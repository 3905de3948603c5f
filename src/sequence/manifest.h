// The manifest of a sequence: a folder beside the frames with `sequence.json`, one file per frame
// (`0012.json`), and `writers`, on which rendering processes hold a lock.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "sequence/names/sequence_name.h"
#include "sequence/record.h"

namespace isomotion::sequence {

// out/name.manifest for out/name.####.png, out/name.exr.manifest for out/name.####.exr; for any
// other name the whole pattern, out/name_##.png.manifest. So two sequences never share a manifest.
// A name without a place for the frame's number has no manifest.
std::filesystem::path manifest_folder(const SequenceName& name);

std::filesystem::path sequence_file(const std::filesystem::path& manifest);
std::filesystem::path frame_file(const std::filesystem::path& manifest, int frame);

// Throws FileError if there is no such file, and an Error (file) with the file's name if it isn't a
// manifest or belongs to files elsewhere.
Sequence read_sequence(const std::filesystem::path& manifest);

// None if there is no readable record of this frame and of this file of it.
std::optional<FrameRecord> find_record(const SequenceName& name, int frame);

} // namespace isomotion::sequence
