// Certified first roots of a picture's rays, without GL.
#pragma once

#include "truth/certify.h"
