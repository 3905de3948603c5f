// Follows the headers of an EXR before OpenEXR reads them.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace isomotion::image::oiio {

// Returns what is wrong with the headers, or an empty text. OpenEXR takes the memory that an
// attribute says to need before it looks for its bytes, and OpenImageIO a time that grows with the
// square of the number of attributes.
//
// Sizes that are not those of their types are refused, too: OpenEXR goes by the type of what it
// knows, and would come to other attributes than those that are counted here.
std::string fault_of_exr_headers(std::span<const std::byte> exr);

} // namespace isomotion::image::oiio
