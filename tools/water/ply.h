#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "anisotropy.h"

namespace water {

/// A PLY file, binary and little endian: a vertex a blob with x y z vx vy vz, its id, the matrix G
/// as gxx gxy gxz gyy gyz gzz, and w, its weight.
std::vector<std::byte> ply_of(std::span<const Blob> blobs);

} // namespace water
