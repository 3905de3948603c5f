// A process's part in a sequence whose frames it renders, alone or with others at the same time.
//
// Processes that render frames of one sequence cooperate. Each adds its requested frames to
// sequence.json, and each frame's record is a file of its own, which appears complete after the
// frame's file. A process that would render something else into these files takes the sequence over
// if no other process works on it, and is refused otherwise. Locks (flock) on the manifest's file
// `writers` show which processes work on it; they end with the process however it ends. On a file
// system without locks none are used.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "base/file_descriptor.h"
#include "sequence/names/sequence_name.h"
#include "sequence/record.h"

namespace isomotion::sequence {

class ManifestWriter {
public:
    // Joins or begins the sequence of these files. The folder of the frames must exist. Throws
    // FileError, and an Error (input) if others render another sequence into these files, with the
    // differences.
    ManifestWriter(const SequenceName& name, const Sequence& sequence);

    const std::filesystem::path& folder() const { return folder_; }

    // The frame's file must be in its place. May be called from any thread. Throws FileError, also
    // if the manifest is no longer the one that was joined, since another sequence may have begun
    // there.
    void record(const FrameRecord& frame) const;

private:
    void join(const Sequence& wanted);
    void expect_manifest() const;

    std::filesystem::path folder_;
    base::FileDescriptor writers_;
};

} // namespace isomotion::sequence
