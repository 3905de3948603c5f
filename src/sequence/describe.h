// What a manifest and the files themselves say about a sequence and its frames, from what they are
// rendered with. Nothing that a file says changes from run to run.
#pragma once

#include <string>
#include <vector>

#include "gpu/context.h"
#include "image/encode.h"
#include "render/renderer.h"
#include "scene/scene_at.h"
#include "sequence/names/sequence_name.h"
#include "sequence/record.h"

namespace isomotion::sequence {

// The name under which a file keeps the fingerprint of what it was rendered from.
inline constexpr const char* fingerprint_key = "isomotion:fingerprint";

// What fits into a file of the format: a parameter's name that is too long is left out, as is a
// rate that 32-bit integers can't hold, which becomes a text. The last entry is the fingerprint's,
// still empty: it covers the others.
image::Metadata frame_metadata(const scene::Scene& scene, const scene::SceneAt& now,
                               const animation::Values& values, int frame, image::Format format);

// Fingerprint of a file: of its pixels, given by their fingerprint, its encoding and its metadata.
std::string file_fingerprint(const std::string& pixels, const std::string& renderer,
                             image::Format format, const image::Metadata& metadata);

Sequence sequence_of(const scene::Scene& scene, const SequenceName& name, image::Format format,
                     const std::vector<synthesis::Channel>& channels, std::vector<int> frames,
                     const gpu::ContextInfo& driver, synthesis::Stage stage,
                     const std::string& shaders_fingerprint);

// All but what is known only once the file is there, the fingerprint and the provenance.
FrameRecord record_of(const scene::Scene& scene, int frame, const animation::Values& values,
                      const render::Picture& picture);

} // namespace isomotion::sequence
