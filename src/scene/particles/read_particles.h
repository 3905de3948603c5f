// Particles from a file of any format, told by its content.
//
// The first bytes tell BGEO, PLY, NPY and VTK, packed by gzip or not. Other texts are XYZ where
// their name ends with .xyz, rows of numbers with .txt, .dat, .pts or .asc, and else CSV (.gz may
// follow).
#pragma once

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

// Takes no more than `most` bytes, packed or unpacked, beside what request.choose allows; says how
// many it had, unpacked. Throws SceneError.
struct ReadParticles {
    ParticleTable table;
    std::size_t bytes = 0;
};
ReadParticles read_particles(const ParticleRequest& request, std::size_t most);
// The same of a file whose bytes are these.
ReadParticles read_particles(const ParticleRequest& request, std::string bytes, std::size_t most);

// How many particles a file holds, by its beginning where that tells; of a text without a count,
// how many there are at most. Takes what had to be read whole off `left`, bytes that may be read to
// count, down to 0. Throws SceneError.
std::size_t count_particles(const std::filesystem::path& file, const base::Confines& within,
                            std::size_t most, std::size_t& left);

} // namespace isomotion::scene
