#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace isomotion::base {

/// Encodes bytes as text for a "data:...;base64," address (RFC 4648).
std::string base64(std::span<const std::byte> bytes);

} // namespace isomotion::base
