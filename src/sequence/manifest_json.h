// Manifests as text: JSON, one key per line.
#pragma once

#include <string>
#include <string_view>

#include "sequence/record.h"

namespace isomotion::sequence {

// Invalid UTF-8 in a name becomes U+FFFD.
std::string to_json(const Sequence& sequence);
std::string to_json(const FrameRecord& record);

// Throw an Error (file) with the place in the file, if it is no manifest or of another version.
Sequence parse_sequence(std::string_view text, const std::string& file);
FrameRecord parse_frame_record(std::string_view text, const std::string& file);

} // namespace isomotion::sequence
