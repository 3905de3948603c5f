#include "sequence/verification.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "animation/frame_range.h"
#include "base/printable.h"
#include "image/decode.h"
#include "sequence/frame_status.h"
#include "sequence/manifest.h"
#include "sequence/manifest_json.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::sequence {
namespace fs = std::filesystem;
namespace {

void note_differences(Verification& found, const FrameRecord& record) {
    const Provenance &wanted = found.sequence.provenance, &made = record.provenance;
    const auto note = [&](const char* what, const std::string& one, const std::string& other) {
        if (one != other) found.differing[what].push_back(record.frame);
    };
    note("scene", made.scene, wanted.scene);
    note("shaders", made.shaders, wanted.shaders);
    note("version", made.version, wanted.version);
    note("renderer", made.renderer, wanted.renderer);
    note("stage", made.stage, wanted.stage);
}

// Manifests may say any count up to 2^54. Sums stay where some of them can be added again.
void add(std::int64_t& sum, std::int64_t count) {
    sum = std::min(sum + count, std::int64_t(1) << 58);
}

template<class Counts> void add(Counts& sums, const Counts& counts) {
    for (std::size_t k = 0; k < sums.size(); ++k) add(sums[k], counts[k]);
}

void sum_up(Verification& found, const FrameRecord& record) {
    add(found.verdicts, record.verdicts);
    if (record.proofs) add(found.proofs, *record.proofs);
    if (record.audit) add(found.audit, *record.audit);
    found.audited += record.audit.has_value();
    add(found.without_colour, record.without_colour);
    add(found.evaluations, record.evaluations);
    found.drawing += record.drawing;
}

bool has_the_pixels(const fs::path& file, const FrameRecord& record) {
    try {
        return image::pixel_hash(file) == record.pixels;
    } catch (const std::runtime_error&) { // it cannot be decoded at all
        return false;
    }
}

void look_at(int frame, const SequenceName& name, bool pixels, Verification& found) {
    const fs::path file = name.path(frame);
    auto record = find_record(name, frame);
    if (record && record->fingerprint.empty()) record.reset(); // none of ours
    switch (frame_status(file, record, record ? record->fingerprint : "", ISOMOTION_VERSION)) {
    case FrameStatus::missing:
        found.missing.push_back(frame);
        return;
    case FrameStatus::foreign:
        found.unrecorded.push_back(frame);
        return;
    case FrameStatus::changed:
    case FrameStatus::stale:
    case FrameStatus::outdated:
        found.changed.push_back(frame);
        return;
    case FrameStatus::whole:
        break;
    }
    if (!record) return; // none is whole without
    found.whole.push_back(frame);
    if (pixels && !has_the_pixels(file, *record)) found.repainted.push_back(frame);
    note_differences(found, *record);
    sum_up(found, *record);
}

// Frames whose files there are, ascending.
std::vector<int> frames_there(const SequenceName& name) {
    std::vector<int> frames;
    const fs::path folder = name.folder().empty() ? "." : name.folder();
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto frame = name.frame_of(entry.path().filename().string());
        if (frame) frames.push_back(*frame);
    }
    std::ranges::sort(frames);
    return frames;
}

using Json = nlohmann::ordered_json;

Json json(const Verification& found) {
    const Sequence& sequence = found.sequence;
    const auto range = [](const std::vector<int>& frames) {
        return animation::frame_range(frames);
    };
    Json differing = Json::object(), rays = Json::object();
    for (const auto& [what, frames] : found.differing) differing[what] = range(frames);
    for (std::size_t v = 0; v < found.verdicts.size(); ++v) {
        rays[render::verdict_names[v]] = found.verdicts[v];
    }
    return {{"manifest", found.manifest.string()},
            {"title", sequence.title},
            {"files", sequence.format.pattern},
            {"frames", range(sequence.asked)},
            {"is whole", found.is_whole()},
            {"whole", range(found.whole)},
            {"missing", range(found.missing)},
            {"changed", range(found.changed)},
            {"unrecorded", range(found.unrecorded)},
            {"other pixels", range(found.repainted)},
            {"differing", differing},
            {"foreign", range(found.foreign)},
            {"rays", rays},
            {"pixels without colour", found.without_colour},
            {"evaluations", found.evaluations},
            {"drawing seconds", found.drawing}};
}

} // namespace

bool Verification::is_whole() const {
    return !sequence.asked.empty() && whole.size() == sequence.asked.size() && repainted.empty() &&
           differing.empty() && foreign.empty();
}

Verification verify(const fs::path& manifest, const VerifyOptions& how) {
    Verification found;
    found.manifest = manifest;
    if (std::error_code ignored; fs::is_symlink(manifest, ignored)) {
        throw Error(Error::Code::file,
                    fmt::format("{}: is a link, and a manifest a folder of its own",
                                base::printable_line(manifest.string())));
    }
    found.sequence = read_sequence(manifest);
    std::vector<int>& asked = found.sequence.asked;
    std::ranges::sort(asked);
    const auto name =
        SequenceName::parse((manifest.parent_path() / found.sequence.format.pattern).string());
    if (const fs::path right = manifest_folder(name); right.filename() != manifest.filename()) {
        throw Error(Error::Code::file,
                    fmt::format("{}: is a manifest of {}, which belongs into {}",
                                base::printable_line(manifest.string()),
                                found.sequence.format.pattern,
                                base::printable_line(right.filename().string())));
    }
    const std::vector<int> there = frames_there(name);
    std::ranges::set_difference(asked, there, std::back_inserter(found.missing));
    std::ranges::set_difference(there, asked, std::back_inserter(found.foreign));
    std::vector<int> present;
    std::ranges::set_intersection(asked, there, std::back_inserter(present));
    for (std::size_t k = 0; k < present.size(); ++k) {
        if (how.progress) how.progress(int(k), int(present.size()));
        look_at(present[k], name, how.pixels, found);
    }
    std::ranges::sort(found.missing); // with links that lead nowhere
    return found;
}

std::string to_json(const std::vector<Verification>& all) {
    Json list = Json::array();
    for (const Verification& found : all) list.push_back(json(found));
    return Json{{"format", "isomotion verification 1"}, {"sequences", list}}.dump(
               2, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

} // namespace isomotion::sequence
