#include "module.h"

#include "image/codecs.h"

extern "C" __attribute__((visibility("default"))) const isomotion::image::Codecs*
ISOMOTION_CODECS_FUNCTION() {
    using namespace isomotion::image;
    static constexpr Codecs functions{oiio::decode, oiio::pixel_hash, oiio::read_environment};
    return &functions;
}
