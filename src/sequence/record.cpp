#include "sequence/record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isomotion::sequence {

std::string difference(const Sequence& first, const Sequence& second) {
    const SequenceFormat &a = first.format, &b = second.format;
    const Provenance &by = first.provenance, &not_by = second.provenance;
    const auto told = [](const char* what, const std::string& one, const std::string& other) {
        return fmt::format("{} {}, not {}", what, one, other);
    };
    if (a.pattern != b.pattern) return told("files", a.pattern, b.pattern);
    if (a.width != b.width || a.height != b.height) {
        return told("size", fmt::format("{}x{}", a.width, a.height),
                    fmt::format("{}x{}", b.width, b.height));
    }
    if (a.encoding != b.encoding) return told("format", a.encoding, b.encoding);
    if (a.channels != b.channels) {
        return told("channels", fmt::format("{}", fmt::join(a.channels, " ")),
                    fmt::format("{}", fmt::join(b.channels, " ")));
    }
    if (a.fps != b.fps) return told("frames a second", a.fps, b.fps);
    if (first.title != second.title) {
        return fmt::format("scene \"{}\", not \"{}\"", first.title, second.title);
    }
    if (by.scene != not_by.scene) return "the same scene with other settings";
    if (by.version != not_by.version) return told("isomotion", by.version, not_by.version);
    if (by.renderer != not_by.renderer) return told("renderer", by.renderer, not_by.renderer);
    if (by.stage != not_by.stage) return told("stage", by.stage, not_by.stage);
    if (by.shaders != not_by.shaders) return "other shaders";
    return {};
}

audit::Findings findings(const AuditCounts& counts) {
    audit::Findings found;
    found.rays = counts[0] + counts[1];
    found.wrong = counts[1];
    found.undecided = counts[2];
    return found;
}

void add(const WrittenFile& file, FrameRecord& record) {
    record.file = file.file.filename().string();
    record.bytes = file.bytes;
    record.hash = file.hash;
    record.pixels = file.pixels;
}

} // namespace isomotion::sequence
