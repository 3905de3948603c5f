// The files of the gallery, which a command may read all of.
#pragma once

#include "sequence/inputs.h"

namespace isomotion::app {

// Of all animations, also of those that have mistakes.
sequence::Inputs gallery_inputs();

} // namespace isomotion::app
