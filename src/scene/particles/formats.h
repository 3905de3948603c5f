// One reader for each particle format. `bytes` are the file's content, unpacked. With
// request.count_alone they may be only its beginning.
#pragma once

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

// Houdini's old binary geometry, as Partio writes it: version V.
ParticleTable read_bgeo(const Bytes& bytes, const ParticleRequest& request);
// The vertices of a PLY file, ascii or binary.
ParticleTable read_ply(const Bytes& bytes, const ParticleRequest& request);
// A NumPy array: two-dimensional with a particle per row, or of records.
ParticleTable read_npy(const Bytes& bytes, const ParticleRequest& request);
// The points of legacy VTK, ascii or binary.
ParticleTable read_vtk(const Bytes& bytes, const ParticleRequest& request);
// The points of VTK's XML: unstructured grids and poly data.
ParticleTable read_vtu(const Bytes& bytes, const ParticleRequest& request);
// A count, a comment line, then lines of a symbol and numbers; the same again for every other time.
ParticleTable read_xyz(const Bytes& bytes, const ParticleRequest& request);
// Atoms of the Protein Data Bank's format; every model is a time.
ParticleTable read_pdb(const Bytes& bytes, const ParticleRequest& request);
// Lines of numbers separated by blanks.
ParticleTable read_rows(const Bytes& bytes, const ParticleRequest& request);
// A header of names, then numbers separated by commas.
ParticleTable read_csv(const Bytes& bytes, const ParticleRequest& request);

} // namespace isomotion::scene
