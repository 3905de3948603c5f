// Particles as other programs write them, in every format that is read. Knows nothing of the
// readers.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isomotion::scene::particles {

// Numbers that a float holds.
struct Cloud {
    std::vector<std::array<float, 3>> position, velocity;
    std::vector<std::int32_t> id;
    std::vector<float> mass;

    std::size_t count() const { return id.size(); }
};

Cloud cloud(int count, unsigned seed);

std::string bgeo(const Cloud& cloud);
// `format`: ascii, binary_little_endian, binary_big_endian. `faces` come before the vertices.
std::string ply(const Cloud& cloud, const std::string& format, bool faces = false);
// Columns x y z vx vy vz alone.
std::string npy_rows(const Cloud& cloud, bool by_columns, bool big_endian);
std::string npy_records(const Cloud& cloud);
std::string vtk(const Cloud& cloud, bool is_ascii, bool is_grid);
enum class Vtu { ascii, inline_base64, appended_base64, appended_raw };
std::string vtu(const Cloud& cloud, Vtu how, bool is_packed, bool long_headers = false,
                bool big_endian = false);
// These have places alone, and velocities where there are no symbols.
std::string xyz(const Cloud& cloud);
std::string rows(const Cloud& cloud);
std::string csv(const Cloud& cloud);

std::string gzip(std::string_view bytes);

struct Sample {
    std::string name; // of the case, a word
    std::string file; // with an extension that says nothing, where content tells
    std::string bytes;
    bool is_text = false; // numbers may be cut off
};
// The cloud in every format and way.
std::vector<Sample> samples(const Cloud& cloud);

} // namespace isomotion::scene::particles
