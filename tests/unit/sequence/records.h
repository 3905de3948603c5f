// A sequence of small made-up files, recorded.
#pragma once

#include <string>

#include "base/content_hash.h"
#include "base/file.h"
#include "image/decode.h"
#include "image/encode.h"
#include "sequence/manifest.h"
#include "sequence/manifest_writer.h"
#include "unit/image/places.h"

namespace isomotion::sequence {

inline Sequence some_sequence(std::vector<int> asked = {1, 2, 3}) {
    Sequence sequence;
    sequence.title = "Sphere";
    sequence.scene_file = "sphere.toml";
    sequence.backend = "egl-surfaceless";
    sequence.provenance = {"scene", "shaders", "0.1.0", "llvmpipe", "fragment"};
    sequence.format = {"a.####.png", 4, 3, "png 8", {"R", "G", "B", "A"}, "30000/1001"};
    sequence.asked = std::move(asked);
    return sequence;
}

class Recorded : public testing::Test {
protected:
    SequenceName name() const { return SequenceName::parse((folder_ / "a.####.png").string()); }
    std::filesystem::path manifest() const { return manifest_folder(name()); }

    // Writes the frame's picture and what is to be said of it.
    FrameRecord write(int frame) const {
        const auto encoded = image::encode_with_hash(image::plain(4, 3, 0.1f * float(frame), 0, 0),
                                                     image::Format::png8);
        base::write_whole(name().path(frame), encoded.bytes);
        FrameRecord record;
        record.frame = frame;
        record.fingerprint = "print " + std::to_string(frame);
        record.provenance = some_sequence().provenance;
        record.verdicts = {7, 5, 0, 0, 0};
        record.evaluations = 100;
        record.drawing = 0.25;
        add({name().path(frame), encoded.bytes.size(), base::content_hash(encoded.bytes),
             encoded.pixels},
            record);
        return record;
    }
    void write_all(const ManifestWriter& recording, int frames) const {
        for (int frame = 1; frame <= frames; ++frame) recording.record(write(frame));
    }

    image::TemporaryFolder folder_;
};

} // namespace isomotion::sequence
