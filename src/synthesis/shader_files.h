// The files of shaders/.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace isomotion::synthesis {

// The text of shaders/<name>. Throws base::InputError if it cannot be read.
std::string read_shader(const std::string& name);

// The files of shaders/math/ that define these kernels ("exp", "pow") and what they need
// themselves, in an order in which each comes after what it needs. bits.glsl is always there.
std::vector<std::string> kernel_files(const std::set<std::string>& kernels);

// The same of shaders/interval/, with the files of shaders/math/ that those need. arithmetic.glsl
// is always there.
std::vector<std::string> interval_files(const std::set<std::string>& kernels);

// What defines the same functions on intervals of doubles: first files for floats, by which some of
// them go, then those for doubles, of which some were among the former.
struct DoubleIntervalFiles {
    std::vector<std::string> for_floats, for_doubles;
};
DoubleIntervalFiles double_interval_files(const std::set<std::string>& kernels);

} // namespace isomotion::synthesis
