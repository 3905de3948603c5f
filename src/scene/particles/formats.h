// One reader for each format of particles. `bytes` are the file's, unpacked; with
// request.count_alone they may be its beginning.
#pragma once

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

// Houdini's old binary geometry, as Partio writes it: version V.
ParticleTable read_bgeo(const Bytes& bytes, const ParticleRequest& request);
// The vertices of a PLY file, ascii or binary.
ParticleTable read_ply(const Bytes& bytes, const ParticleRequest& request);
// An array of NumPy: of two dimensions, a particle a row, or of records.
ParticleTable read_npy(const Bytes& bytes, const ParticleRequest& request);
// The points of legacy VTK, ascii or binary.
ParticleTable read_vtk(const Bytes& bytes, const ParticleRequest& request);
// The points of VTK's XML: unstructured grids and poly data.
ParticleTable read_vtu(const Bytes& bytes, const ParticleRequest& request);
// A count, a comment and lines of a symbol and numbers.
ParticleTable read_xyz(const Bytes& bytes, const ParticleRequest& request);
// Lines of numbers with blanks between them.
ParticleTable read_rows(const Bytes& bytes, const ParticleRequest& request);
// A header of names, then numbers with commas between them.
ParticleTable read_csv(const Bytes& bytes, const ParticleRequest& request);

} // namespace isomotion::scene
