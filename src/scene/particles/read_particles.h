// Reads particles from a file of any format and detects the format by the content.
//
// The first bytes identify BGEO, PLY, NPY, VTK and most of PDB, packed by gzip or not. For other
// texts the name decides: .xyz is XYZ; .pdb and .ent are PDB; .txt, .dat, .pts and .asc are rows of
// numbers; all others are CSV (.gz may follow).
#pragma once

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

// Takes at most `most` bytes, packed or unpacked, besides what request.choose allows. Returns the
// number of unpacked bytes, too. Throws SceneError.
struct ReadParticles {
    ParticleTable table;
    std::size_t bytes = 0;
};
ReadParticles read_particles(const ParticleRequest& request, std::size_t most);
// The same for a file with this content.
ReadParticles read_particles(const ParticleRequest& request, std::string bytes, std::size_t most);

// The number of particles in a file, read from its beginning if that states it. For a text without
// a count it is an upper bound. Subtracts the bytes that had to be read whole from `left`, the
// bytes that may still be read to count, down to 0. Throws SceneError.
std::size_t count_particles(const std::filesystem::path& file, const base::Confines& within,
                            std::size_t most, std::size_t& left);

} // namespace isomotion::scene
