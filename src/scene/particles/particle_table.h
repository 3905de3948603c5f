// Particles of a file, whatever its format: columns of numbers.
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

// Numbers where the file has them, one a particle.
struct RawColumn {
    const char* first = nullptr;
    std::size_t stride = 0;
    Scalar type = Scalar::f32;
    bool big_endian = false;
    const char* file = nullptr; // its first byte, or null where the numbers were packed
    double unit = 1;            // multiplies the numbers
};

struct ParticleColumn {
    std::string name;
    // In a table from a text the numbers themselves, none where nobody wanted the column.
    std::variant<std::vector<double>, RawColumn> values;
};

using Bytes = std::shared_ptr<const std::string>;

struct ParticleTable {
    std::string format; // "PLY, ascii"
    std::size_t count = 0;
    std::vector<ParticleColumn> columns;
    std::vector<std::int32_t> lines{}; // of a text: the line of each particle
    int end_line = 0;                  // of a text with a header: the last
    std::vector<std::size_t> bare{};   // rows that say nothing but their time, ascending
    std::vector<Bytes> kept{};         // where raw columns lie
};

// Which columns of a file are read, and how much of them there may be.
struct Wanted {
    std::vector<bool> columns;
    std::size_t most = 0;              // particles
    double values = 0;                 // numbers that are kept
    std::optional<std::size_t> time{}; // the column that tells it
    // How many numbers are kept of each particle; without it one for each column that is read.
    std::optional<std::size_t> kept{};

    // How many numbers so many particles have.
    double numbers(std::size_t count) const;
};

// Thrown by the choice of columns; the reader says where their names are.
struct NamedColumn {
    std::string column, message;
};

// What a reader of a format goes by.
struct ParticleRequest {
    std::filesystem::path file;
    base::Confines within{}; // where it must lie when it is opened
    // Asked once, as soon as the names are known; may throw NamedColumn.
    std::function<Wanted(const std::string& format, const std::vector<std::string>& names)> choose;
    // Only `count` is asked for, of what may be a file's beginning alone.
    bool count_alone = false;
};

// Throws SceneError: "drops.ply:7: ..." of a text, "drops.ply: byte 99: ..." of others.
[[noreturn]] void fail_at_line(const ParticleRequest& request, int line,
                               const std::string& message);
[[noreturn]] void fail_at_byte(const ParticleRequest& request, std::size_t byte,
                               const std::string& message);
[[noreturn]] void fail_of_file(const ParticleRequest& request, const std::string& message);

// Asks which columns are wanted, and refuses more particles or numbers than there may be, columns
// beyond the limit and two of one name, all before any of them is stored.
Wanted wanted_of(const ParticleRequest& request, const std::string& format,
                 const std::vector<std::string>& names, std::size_t count);

// Makes numbers from 0 to 1 of colours in whole bytes or pairs of them: where columns r, g and b
// are all of such a type, and of an a beside them. `types` are those of the columns.
void scale_colors(ParticleTable& table, std::span<const Scalar> types);

// "drops.ply:7" or "drops.ply: byte 99: particle 3".
std::string place(const ParticleTable& table, const std::filesystem::path& file, std::size_t column,
                  std::size_t row);

// The numbers of a column, all of them finite. A column of a text is taken out of the table.
std::vector<double> take_numbers(ParticleTable& table, const std::filesystem::path& file,
                                 std::size_t column);
// The same of whole numbers, exact in 64 bits.
std::vector<std::int64_t> take_whole_numbers(ParticleTable& table,
                                             const std::filesystem::path& file, std::size_t column);

} // namespace isomotion::scene
