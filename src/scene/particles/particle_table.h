// Particles of a file of any format, as columns of numbers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/confines.h"

namespace isomotion::scene {

enum class Scalar : char { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

constexpr std::size_t size_of(Scalar type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return sizes[std::size_t(type)];
}

// Numbers where they lie in the file's bytes, one per particle.
struct RawColumn {
    const char* first = nullptr;
    std::size_t stride = 0;
    Scalar type = Scalar::f32;
    bool big_endian = false;
    const char* file = nullptr; // first byte of the file, or null if the numbers were packed
    double unit = 1;            // multiplies the numbers
};

struct ParticleColumn {
    std::string name;
    // From a text file the numbers themselves; empty if nobody wanted the column.
    std::variant<std::vector<double>, RawColumn> values;
};

using Bytes = std::shared_ptr<const std::string>;

struct ParticleTable {
    std::string format; // "PLY, ascii"
    std::size_t count = 0;
    std::vector<ParticleColumn> columns;
    std::vector<std::int32_t> lines{}; // text files: the line of each particle
    int end_line = 0;                  // text files with a header: its last line
    std::vector<std::size_t> bare{};   // rows that state only their time, ascending
    std::vector<Bytes> kept{};         // the bytes that raw columns point into
};

// Which columns of a file are read, and limits on their size.
struct Wanted {
    std::vector<bool> columns;
    std::size_t most = 0;              // particles
    double values = 0;                 // numbers that are kept
    std::optional<std::size_t> time{}; // the column that holds the time
    // How many numbers are kept per particle; if unset, one for each column that is read.
    std::optional<std::size_t> kept{};

    // How many numbers `count` particles have.
    double numbers(std::size_t count) const;
};

// Thrown by the choice of columns; the reader adds where their names are.
struct NamedColumn {
    std::string column, message;
};

// The input of a format's reader.
struct ParticleRequest {
    std::filesystem::path file;
    base::Confines within{}; // where it must lie when it is opened
    // Called once, as soon as the names are known; may throw NamedColumn.
    std::function<Wanted(const std::string& format, const std::vector<std::string>& names)> choose;
    // Only `count` is needed; the bytes may be only the beginning of the file.
    bool count_alone = false;
};

// Throw SceneError: "drops.ply:7: ..." for text files, "drops.ply: byte 99: ..." for others.
[[noreturn]] void fail_at_line(const ParticleRequest& request, int line,
                               const std::string& message);
[[noreturn]] void fail_at_byte(const ParticleRequest& request, std::size_t byte,
                               const std::string& message);
[[noreturn]] void fail_of_file(const ParticleRequest& request, const std::string& message);

// Asks which columns are wanted. Refuses too many particles or numbers, columns beyond the limit
// and two columns of one name, all before any number is stored.
Wanted wanted_of(const ParticleRequest& request, const std::string& format,
                 const std::vector<std::string>& names, std::size_t count);

// Scales colours of one- or two-byte integers to 0..1, if columns r, g and b all have such a type;
// scales a column a beside them, too. `types` are the columns' types.
void scale_colors(ParticleTable& table, std::span<const Scalar> types);

// "drops.ply:7" or "drops.ply: byte 99: particle 3".
std::string place(const ParticleTable& table, const std::filesystem::path& file, std::size_t column,
                  std::size_t row);

// The numbers of a column; all must be finite. A column of a text file is moved out of the table.
std::vector<double> take_numbers(ParticleTable& table, const std::filesystem::path& file,
                                 std::size_t column);
// The same for whole numbers, exact in 64 bits.
std::vector<std::int64_t> take_whole_numbers(ParticleTable& table,
                                             const std::filesystem::path& file, std::size_t column);

} // namespace isomotion::scene
