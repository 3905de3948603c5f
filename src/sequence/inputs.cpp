#include "sequence/inputs.h"

#include <fmt/format.h>

#include <isomotion/error.h>

#include "base/file_stamp.h"
#include "base/printable.h"
#include "scene/files_read.h"

namespace isomotion::sequence {
namespace fs = std::filesystem;

Inputs::Inputs(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) add(file);
}

Inputs::Inputs(const scene::Scene& scene)
    : Inputs(scene::files_read(scene)) {}

void Inputs::add(const fs::path& file) {
    if (const auto stamp = base::stamp_of(file))
        files_.insert({{stamp->device, stamp->file}, file});
}

void Inputs::expect_apart(std::string_view option, const fs::path& output) const {
    if (output.empty()) return;
    const auto stamp = base::stamp_of(output);
    if (!stamp) return;
    const auto input = files_.find({stamp->device, stamp->file});
    if (input == files_.end()) return;
    throw Error(Error::Code::setting,
                fmt::format("{} {}: would replace {}, which is read for it; name another file",
                            option, base::printable_line(output.string()),
                            base::printable_line(input->second.string())));
}

void Inputs::expect_apart(std::string_view option, const SequenceName& frames) const {
    if (!frames.holds_many()) return expect_apart(option, frames.path(1));
    const fs::path folder = frames.folder().empty() ? "." : frames.folder();
    std::error_code none; // a folder that is not there yet holds no input
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        if (frames.frame_of(entry.path().filename().string())) expect_apart(option, entry.path());
    }
}

} // namespace isomotion::sequence
