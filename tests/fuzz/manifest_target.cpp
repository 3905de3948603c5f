#include "base/printable.h"
#include "fuzz/targets.h"
#include "sequence/manifest_json.h"

namespace isomotion::fuzz {
namespace {

// What is read is written, and read again it is the same.
template<class Parse> void read_and_write(std::string_view text, Parse parse) {
    try {
        const std::string written = sequence::to_json(parse(text));
        if (sequence::to_json(parse(written)) != written)
            throw Violation("read again, another record");
    } catch (const Error& error) {
        if (base::printable(error.what()) != error.what()) {
            throw Violation("a message that commands a terminal");
        }
    }
}

} // namespace

void manifest(std::string_view text) {
    read_and_write(text, [](std::string_view t) { return sequence::parse_sequence(t, "a"); });
    read_and_write(text, [](std::string_view t) { return sequence::parse_frame_record(t, "a"); });
}

} // namespace isomotion::fuzz
