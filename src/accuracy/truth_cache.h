// Keeps certified truth on disk, so that sweeps over many settings certify only once.
#pragma once

#include <filesystem>

#include "roots/certify.h"

namespace isomotion::accuracy {

// $XDG_CACHE_HOME/isomotion/truth, or ~/.cache/isomotion/truth; empty if neither is known.
std::filesystem::path truth_cache_folder();

// Reads the truth from a file of `folder`, or certifies it and writes the file. The file's name is
// the fingerprint of everything that truth depends on. A file that is damaged or cannot be written
// only costs time. With an empty `folder` nothing is kept.
roots::Truth remembered_truth(const scene::Scene& scene, const scene::SceneAt& now, int width,
                              int height, const roots::Certifying& how,
                              const std::filesystem::path& folder);

} // namespace isomotion::accuracy
