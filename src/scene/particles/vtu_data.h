// Decodes the numbers of an array of VTK's XML to bytes.
#pragma once

#include <string>
#include <string_view>

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

// How a file encodes its arrays.
struct VtuCoding {
    bool is_base64 = true;
    bool is_packed = false; // by zlib, in blocks
    bool has_long_headers = false;
    bool big_endian = false;
};

// The `size` bytes of an array that begins at byte `at` of the text and may extend to its end.
// Takes no more memory than that.
std::string vtu_data(const ParticleRequest& request, std::string_view text, std::size_t at,
                     const VtuCoding& coding, std::size_t size);

} // namespace isomotion::scene
