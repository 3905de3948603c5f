// Certified truth, remembered on disk: a sweep over many settings, or again another day, certifies
// once.
#pragma once

#include <filesystem>

#include "truth/certify.h"

namespace isomotion::accuracy {

// $XDG_CACHE_HOME/isomotion/truth, or ~/.cache/isomotion/truth; empty if neither is known.
std::filesystem::path truth_cache_folder();

// Truth from a file of `folder`, or certified and put there. The file's name is the fingerprint of
// everything that truth depends on; a file that is damaged or cannot be written only costs the
// time. An empty folder remembers nothing.
truth::Truth remembered_truth(const scene::Scene& scene, const scene::SceneAt& now, int width,
                              int height, const truth::Certifying& how,
                              const std::filesystem::path& folder);

} // namespace isomotion::accuracy
