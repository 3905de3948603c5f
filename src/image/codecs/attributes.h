#pragma once

#include <OpenImageIO/imageio.h>

#include "image/frame.h"

namespace isomotion::image::oiio {

// Adds the entries to a specification with the types they have.
void add_typed(OIIO::ImageSpec& spec, const Metadata& metadata);

// Adds the entries to a specification as text, for PNG, which has no other type.
void add_as_text(OIIO::ImageSpec& spec, const Metadata& metadata);

// The entries that a file was written with, without those that describe the file itself.
Metadata entries_of(const OIIO::ImageSpec& spec);

// Every file gets this date if its metadata has none: OpenEXR would write the present time, and
// two runs would never give the same bytes.
inline constexpr const char* no_date = "1970:01:01 00:00:00";

} // namespace isomotion::image::oiio
