// The records of a manifest: of a whole sequence, and of each of its frames.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audit/audit.h"
#include "render/proofs.h"
#include "render/renderer.h"
#include "sequence/writer.h"

namespace isomotion::sequence {

// The origin of frames. Frames of different provenance don't belong to one sequence, even if their
// pictures happen to be equal.
struct Provenance {
    std::string scene;    // scene_fingerprint()
    std::string shaders;  // fingerprint of their text
    std::string version;  // of isomotion
    std::string renderer; // as the driver names itself, with its version
    std::string stage;

    bool operator==(const Provenance&) const = default;
};

// The format that all files of a sequence share.
struct SequenceFormat {
    std::string pattern; // name.####.png
    int width = 0, height = 0;
    std::string encoding; // "png 8", "png 16", "exr"
    std::vector<std::string> channels;
    std::string fps; // "30", "30000/1001"

    bool operator==(const SequenceFormat&) const = default;
};

struct Sequence {
    std::string title, scene_file;
    std::string backend; // of the process that rendered first; all back ends give the same pictures
    Provenance provenance;
    SequenceFormat format;
    std::vector<int> asked; // frames requested in all runs so far, ascending
};

// The differences between the two, for a message: "size 64x64, not 48x48", the first's value first.
// Empty if frames of both may be in one sequence.
std::string difference(const Sequence& first, const Sequence& second);

inline constexpr std::array audit_names{"right", "wrong", "undecided"};
using AuditCounts = std::array<std::int64_t, audit_names.size()>;

// Findings in the frames that were audited.
audit::Findings findings(const AuditCounts& counts);

struct FrameRecord {
    int frame = 0;
    std::string file; // the last part of its path
    std::uintmax_t bytes = 0;
    std::string hash;        // base::content_hash() of the file
    std::string pixels;      // image::pixel_hash() of it
    std::string fingerprint; // of all inputs of the file
    Provenance provenance;
    double time = 0; // of the scene, seconds
    std::vector<std::pair<std::string, double>> parameters;
    std::array<std::int64_t, render::verdict_names.size()> verdicts{}; // rays
    std::optional<render::ProofCounts> proofs;                         // pixels, if certified
    std::optional<AuditCounts> audit;                                  // rays, if there was one
    std::int64_t without_colour = 0; // pixels whose colour is infinite or NaN
    std::int64_t evaluations = 0;
    // By kind of ray: evaluations, the most of these for a pixel, rays that stayed undecided.
    // Earlier versions recorded none.
    using ByKind = std::array<std::int64_t, render::ray_kind_names.size()>;
    std::optional<ByKind> by_kind, most_of_a_pixel, undecided;
    double drawing = 0; // seconds; 0 for a copy of the previous frame's picture
};

// Adds to a record the data of its file once that exists.
void add(const WrittenFile& file, FrameRecord& record);

} // namespace isomotion::sequence
