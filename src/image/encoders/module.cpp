#include "module.h"

#include "image/encoders.h"

extern "C" __attribute__((visibility("default"))) const isomotion::image::Encoders*
ISOMOTION_ENCODERS_FUNCTION() {
    using namespace isomotion::image;
    static constexpr Encoders functions{files::encode};
    return &functions;
}
