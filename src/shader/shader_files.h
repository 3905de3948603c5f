// Reads the files of shaders/.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace isomotion::shader {

// The text of shaders/<name>. Throws base::InputError if it cannot be read.
std::string read_shader(const std::string& name);

// The files of shaders/math/ that define these kernels ("exp", "pow") and the files these need,
// each after what it needs. Always includes bits.glsl.
std::vector<std::string> kernel_files(const std::set<std::string>& kernels);

// The same for shaders/interval/, with the files of shaders/math/ that those need. Always includes
// arithmetic.glsl.
std::vector<std::string> interval_files(const std::set<std::string>& kernels);

// The files that define the same functions on intervals of doubles: first files for floats, which
// some of them use, then those for doubles. Some files are in both lists.
struct DoubleIntervalFiles {
    std::vector<std::string> for_floats, for_doubles;
};
DoubleIntervalFiles double_interval_files(const std::set<std::string>& kernels);

} // namespace isomotion::shader
