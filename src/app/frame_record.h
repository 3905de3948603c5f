// What a manifest says about a sequence and its frames, from what they are rendered with.
#pragma once

#include <string>
#include <vector>

#include "gpu/context.h"
#include "image/sequence.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "sequence/record.h"

namespace isomotion::app {

sequence::Sequence sequence_of(const scene::Scene& scene, const image::SequenceName& name,
                               image::Format format,
                               const std::vector<synthesis::Channel>& channels,
                               std::vector<int> frames, const gpu::ContextInfo& driver,
                               synthesis::Stage stage, const std::string& shaders_fingerprint);

// All but what is known only once the file is there, the fingerprint and the making.
sequence::FrameRecord record_of(const scene::Scene& scene, int frame,
                                const animation::Values& values, const render::Picture& picture);

} // namespace isomotion::app
