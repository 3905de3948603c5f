#include "base/printable.h"
#include "fuzz/targets.h"
#include "topology/timeline/document.h"
#include "topology/timeline/timeline_file.h"

namespace isomotion::fuzz {

void timeline(std::string_view text) {
    try {
        const topology::TimelineRecord record = topology::parse_timeline(text, "file");
        if (topology::parse_timeline(topology::to_json(record), "file") != record) {
            throw Violation("written and read again, another timeline");
        }
    } catch (const topology::DocumentError& error) {
        if (base::printable(error.what()) != error.what()) {
            throw Violation("a message that commands a terminal");
        }
    }
}

} // namespace isomotion::fuzz
