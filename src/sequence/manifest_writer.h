// A process's part in a sequence that it renders frames of, alone or with others at the same time.
//
// Processes that render frames of one sequence agree: each adds the frames it is asked for to
// sequence.json, and each frame's record is a file of its own, which appears whole after the
// frame's. A process that would render something else into these files takes the sequence over if
// nobody is at work on it, and is refused if somebody is. Who is at work is known by locks (flock)
// on the manifest's file `writers`, which end with the process however it ends. A file system
// without locks is used without.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "base/file_descriptor.h"
#include "sequence/names/sequence_name.h"
#include "sequence/record.h"

namespace isomotion::sequence {

// Others are rendering another sequence into these files; the message says what differs.
class ConflictError : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

class ManifestWriter {
public:
    // Joins the sequence of these files or begins it. The folder of the frames must be there.
    // Throws FileError, ConflictError.
    ManifestWriter(const SequenceName& name, const Sequence& sequence);

    const std::filesystem::path& folder() const { return folder_; }

    // The frame's file must be in its place. From any thread. Throws FileError, also if the
    // manifest is no longer the one that was joined: another sequence may have begun there.
    void record(const FrameRecord& frame) const;

private:
    void join(const Sequence& wanted);
    void expect_manifest() const;

    std::filesystem::path folder_;
    base::FileDescriptor writers_;
};

} // namespace isomotion::sequence
