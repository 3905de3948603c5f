// The shaders that make the picture from where rays ended.
#pragma once

#include "scene/scene.h"
#include "synthesis/march_text.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

// The channels that the shade pass writes, in the order of its attachments, whatever the order in
// which they are asked for.
std::vector<Channel> written_channels(const std::vector<Channel>& channels);

// Whether march and picture may be one draw: nothing but the picture needs where rays ended.
bool can_fuse(const scene::Scene& scene, const std::vector<Channel>& channels);
Pass fused_pass(const scene::Scene& scene, const Passes& passes);
Pass mask_pass(const scene::Scene& scene, const Passes& passes);

Pass surface_pass(const scene::Scene& scene, const Passes& passes, Origin origin, When when);
// What mirrored rays see of this surface among several.
Pass seen_pass(const scene::Scene& scene, const Passes& passes);
Pass shade_pass(const scene::Scene& scene, const Passes& passes, When when);
// The channel velocity.
Pass motion_pass(const scene::Scene& scene, const Passes& passes);

} // namespace isomotion::synthesis
