// Manifests as text: JSON, one key per line.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "sequence/record.h"

namespace isomotion::sequence {

// The text is not a manifest, or has another format version.
class ManifestError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Invalid UTF-8 in a name becomes U+FFFD.
std::string to_json(const Sequence& sequence);
std::string to_json(const FrameRecord& record);

// Throw ManifestError with the place in the file.
Sequence parse_sequence(std::string_view text, const std::string& file);
FrameRecord parse_frame_record(std::string_view text, const std::string& file);

} // namespace isomotion::sequence
