#include "app/new_file.h"

#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "base/partial_file.h"

namespace isomotion::app {

void write_new_file(const std::filesystem::path& file, std::string_view text) {
    std::error_code error;
    if (std::filesystem::exists(std::filesystem::symlink_status(file, error))) {
        throw std::invalid_argument(fmt::format(
            "{}: is there already and is not written over; name another file", file.string()));
    }
    base::PartialFile partial(file);
    partial.write(std::as_bytes(std::span(text)));
    partial.publish();
}

} // namespace isomotion::app
