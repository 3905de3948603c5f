// Whether a sequence on the disk is whole: every frame that was asked for, as it was written, by
// one provenance, and nothing between them that nobody rendered.
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

    std::vector<int> whole; // frames; the others are in one of the following
    std::vector<int> missing;
    std::vector<int> changed;    // since they were recorded
    std::vector<int> unrecorded; // there, but nobody says what they are
    std::vector<int> repainted;  // of whole ones: their pixels are not those that were recorded
    // Whole ones that were made otherwise than the sequence: by "scene", "version", "renderer", ...
    std::map<std::string, std::vector<int>> differing;
    // Frames' files that the sequence was never asked for.
    std::vector<int> foreign;

    // Sums over the records of the frames that are whole.
    std::array<std::int64_t, render::verdict_names.size()> verdicts{};
    render::ProofCounts proofs{};
    AuditCounts audit{};
    int audited = 0; // frames
    std::int64_t without_colour = 0;
    std::int64_t evaluations = 0;
    double drawing = 0; // seconds

    bool is_whole() const;
};

struct VerifyOptions {
    bool pixels = false; // decode each picture, too
    std::function<void(int done, int of)> progress = {};
};

// Throws FileError and ManifestError if there is no manifest to read.
Verification verify(const std::filesystem::path& manifest, const VerifyOptions& how = {});

std::string to_json(const std::vector<Verification>& all);

} // namespace isomotion::sequence
