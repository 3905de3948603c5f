#include "base/input_error.h"
#include "base/printable.h"
#include "fuzz/targets.h"
#include "topology/timeline/expectation.h"

namespace isomotion::fuzz {

void claims(std::string_view text) {
    for (const char* file : {"claims.json", "claims.toml"}) {
        try {
            const topology::Claims claims =
                topology::parse_claims(text, file, animation::FrameRate{30, 1});
            topology::check(claims, topology::TimelineRecord{});
        } catch (const base::InputError& error) {
            if (base::printable(error.what()) != error.what()) {
                throw Violation("a message that commands a terminal");
            }
        }
    }
}

} // namespace isomotion::fuzz
