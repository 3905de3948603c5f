#pragma once

#include <span>
#include <vector>

#include "fluid.h"

namespace water {

/// How a surface is made of particles.
struct SurfaceSettings {
    float kernel = 2;          // the radius h of a kernel in a full neighbourhood, in spacings
    float reach = 3;           // of the neighbourhood r, in spacings
    float smoothing = 0.9F;    // lambda
    float most_stretch = 4;    // k_r
    float alone = 0.5F;        // k_n: the radius of a particle alone, as a part of h
    int few = 10, enough = 25; // N_eps: neighbours from which kernels begin and end to stretch
};

/// A particle as the surface sees it. The field of all,
///     sum of weight * max(0, 1 - |G (x - centre)|^2)^3,
/// is some 1 within the water; its surface is where the field is 1/2.
struct Blob {
    Vec3 centre, velocity;
    float g[6]; // xx xy xz yy yz zz of the symmetric matrix G
    float weight;
};

/// Yu & Turk, "Reconstructing surfaces of particle-based fluids using anisotropic kernels", ACM
/// Transactions on Graphics 2013. The k-th blob is of the particle with id k.
std::vector<Blob> blobs_of(const Fluid& fluid, const SurfaceSettings& settings);

} // namespace water
