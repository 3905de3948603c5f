#pragma once

#include "gpu/context.h"

#include <memory>
#include <utility>
#include <vector>

namespace isomotion::gpu {

/// Core profile versions to ask for, best first. Asking for more than 4.5 fails on Mesa's software
/// rasteriser instead of giving the best it has.
inline constexpr std::pair<int, int> wanted_versions[] = {{4, 5}, {3, 3}};

// Each opens a context that is not yet current, or returns null and adds why to `failed`.
std::unique_ptr<Context> open_egl(std::vector<Attempt>& failed);
std::unique_ptr<Context> open_osmesa(std::vector<Attempt>& failed);
std::unique_ptr<Context> open_glfw(std::vector<Attempt>& failed);

/// The library that OpenGL's functions were loaded from may be gone: the next context that is made
/// current loads them again.
void forget_functions() noexcept;

} // namespace isomotion::gpu
