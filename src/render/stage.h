// The shader stage that marches the rays of a picture.
#pragma once

#include <string_view>

#include "gpu/context.h"
#include "shader/stage.h"

namespace isomotion::render {

enum class StageChoice { fragment, compute, automatic };

// Throws std::invalid_argument that lists the valid names.
StageChoice parse_stage(std::string_view text);
std::string_view name(shader::Stage stage);

// `automatic` uses compute shaders where they are known to be much faster, otherwise fragment
// shaders. Throws gpu::ResourceError if compute shaders are requested and the driver has none.
shader::Stage choose_stage(StageChoice choice, const gpu::ContextInfo& info);

} // namespace isomotion::render
