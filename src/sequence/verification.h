// Verifies that a sequence on disk is complete: every requested frame exists, as it was written,
// with one provenance, and there are no other frames among them.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sequence/record.h"

namespace isomotion::sequence {

struct Verification {
    std::filesystem::path manifest;
    Sequence sequence;

    std::vector<int> whole; // frames; every other frame is in one of the following
    std::vector<int> missing;
    std::vector<int> changed;    // since they were recorded
    std::vector<int> unrecorded; // present, but without a record
    std::vector<int> repainted;  // among `whole`: their pixels differ from those recorded
    // Whole frames with another provenance than the sequence: by "scene", "version", "renderer",
    // ...
    std::map<std::string, std::vector<int>> differing;
    // Files of frames that were never requested.
    std::vector<int> foreign;

    // Sums over the records of the whole frames.
    std::array<std::int64_t, render::verdict_names.size()> verdicts{};
    render::ProofCounts proofs{};
    AuditCounts audit{};
    int audited = 0; // frames
    std::int64_t without_colour = 0;
    std::int64_t evaluations = 0;
    double drawing = 0; // seconds

    // Also false if nothing was asked for: no run of the program leaves such a manifest.
    bool is_whole() const;
};

struct VerifyOptions {
    bool pixels = false; // also decode each picture
    std::function<void(int done, int of)> progress = {};
};

// Throws an Error (file) if there is no manifest to read. Opens only files that exist:
// the time does not depend on how many frames a manifest says were asked for.
Verification verify(const std::filesystem::path& manifest, const VerifyOptions& how = {});

std::string to_json(const std::vector<Verification>& all);

} // namespace isomotion::sequence
