// Describes a sequence and its frames, for manifests and for the files themselves, from the inputs
// of rendering. The content of files doesn't change from run to run.
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

// The name under which a file keeps the fingerprint of its inputs.
inline constexpr const char* fingerprint_key = "isomotion:fingerprint";

// The entries that fit into a file of the format. A parameter's name that is too long is left out;
// a rate that 32-bit integers can't hold becomes a text. The last entry is the fingerprint's, still
// empty, since the fingerprint covers the others.
image::Metadata frame_metadata(const scene::Scene& scene, const scene::SceneAt& now, int frame,
                               image::Format format);

// Fingerprint of a file: of its pixels (given by their fingerprint), its encoding and its metadata.
std::string file_fingerprint(const std::string& pixels, const std::string& renderer,
                             image::Format format, const image::Metadata& metadata);

Sequence sequence_of(const scene::Scene& scene, const SequenceName& name, image::Format format,
                     const std::vector<shader::Channel>& channels, std::vector<int> frames,
                     const gpu::ContextInfo& driver, shader::Stage stage,
                     const std::string& shaders_fingerprint);

// Everything except the fingerprint, the provenance and what is known only once the file exists.
FrameRecord record_of(const scene::Scene& scene, int frame, const scene::SceneAt& now,
                      const render::Picture& picture);

} // namespace isomotion::sequence
