// Which shader stage marches the rays of a picture.
#pragma once

#include <string_view>

#include "gpu/context.h"
#include "synthesis/stage.h"

namespace isomotion::render {

enum class StageChoice { fragment, compute, automatic };

// Throws std::invalid_argument that lists the names there are.
StageChoice parse_stage(std::string_view text);
std::string_view name(synthesis::Stage stage);

// `automatic` takes compute shaders where they are known to be faster by far, and fragment shaders
// else. Throws gpu::ResourceError where compute shaders are asked for and the driver has none.
synthesis::Stage choose_stage(StageChoice choice, const gpu::ContextInfo& info);

} // namespace isomotion::render
