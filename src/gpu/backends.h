#pragma once

#include "gpu/context.h"

#include <memory>
#include <utility>
#include <vector>

namespace isomotion::gpu {

/// Core profile versions to request, best first. On Mesa's software rasteriser a request for more
/// than 4.5 fails instead of giving the best version available.
inline constexpr std::pair<int, int> wanted_versions[] = {{4, 5}, {3, 3}};

// Each opens a context that is not yet current, or returns null and adds the reason to `failed`.
std::unique_ptr<Context> open_egl(std::vector<Attempt>& failed);
std::unique_ptr<Context> open_osmesa(std::vector<Attempt>& failed);
std::unique_ptr<Context> open_glfw(std::vector<Attempt>& failed);

/// Call it if the library that OpenGL's functions were loaded from may be gone. The next context
/// that is made current loads them again.
void forget_functions() noexcept;

} // namespace isomotion::gpu
