#include "scene/particles/particle_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "base/printable.h"
#include "scene/error.h"
#include "scene/limits.h"

namespace isomotion::scene {
namespace {

template<class T> T number_at(const char* at, bool swaps) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, at, sizeof(T));
    if (swaps) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

// Calls `use` with a function that reads one number.
template<class Use> void with_reader(const RawColumn& raw, Use&& use) {
    const bool swaps = raw.big_endian != (std::endian::native == std::endian::big);
    const auto as = [&]<class T>(T) {
        if (swaps) {
            use([](const char* at) { return number_at<T>(at, true); });
        } else {
            use([](const char* at) { return number_at<T>(at, false); });
        }
    };
    switch (raw.type) {
    case Scalar::i8:
        return as(std::int8_t());
    case Scalar::u8:
        return as(std::uint8_t());
    case Scalar::i16:
        return as(std::int16_t());
    case Scalar::u16:
        return as(std::uint16_t());
    case Scalar::i32:
        return as(std::int32_t());
    case Scalar::u32:
        return as(std::uint32_t());
    case Scalar::i64:
        return as(std::int64_t());
    case Scalar::u64:
        return as(std::uint64_t());
    case Scalar::f32:
        return as(float());
    case Scalar::f64:
        return as(double());
    }
}

template<class To> std::vector<To> decoded(const RawColumn& raw, std::size_t count) {
    std::vector<To> values(count);
    with_reader(raw, [&](auto read) {
        const char* at = raw.first;
        for (To& value : values) {
            value = To(read(at)); // NOLINT(bugprone-signed-char-misuse): a number
            at += raw.stride;
        }
    });
    return values;
}

// Names may hold line ends.
std::string shown(const std::filesystem::path& file) { return base::printable_line(file.string()); }

bool is_whole(Scalar type) { return type != Scalar::f32 && type != Scalar::f64; }

} // namespace

void fail_at_line(const ParticleRequest& request, int line, const std::string& message) {
    throw SceneError(fmt::format("{}:{}: {}", shown(request.file), line, message));
}

void fail_at_byte(const ParticleRequest& request, std::size_t byte, const std::string& message) {
    throw SceneError(fmt::format("{}: byte {}: {}", shown(request.file), byte, message));
}

void fail_of_file(const ParticleRequest& request, const std::string& message) {
    throw SceneError(fmt::format("{}: {}", shown(request.file), message));
}

double Wanted::numbers(std::size_t count) const {
    return double(kept.value_or(std::size_t(std::ranges::count(columns, true)))) * double(count);
}

Wanted wanted_of(const ParticleRequest& request, const std::string& format,
                 const std::vector<std::string>& names, std::size_t count) {
    if (names.size() > std::size_t(limits::fields)) {
        fail_of_file(request, fmt::format("has {} columns; at most {} are read", names.size(),
                                          limits::fields));
    }
    std::vector<std::string> sorted = names;
    std::ranges::sort(sorted);
    const auto twin = std::ranges::adjacent_find(sorted);
    if (twin != sorted.end())
        fail_of_file(request, fmt::format("{}: two columns have this name", *twin));
    Wanted wanted;
    try {
        wanted = request.choose(format, names);
    } catch (const NamedColumn& wrong) {
        fail_of_file(request, fmt::format("{}: {}", wrong.column, wrong.message));
    }
    if (count > wanted.most) {
        fail_of_file(request, fmt::format("says that it holds {} particles; there may be {}", count,
                                          wanted.most));
    }
    if (wanted.numbers(count) > wanted.values) {
        fail_of_file(request, fmt::format("has {} particles, and {:.3g} numbers of them are kept; "
                                          "all tables of a scene hold at most {:.3g}",
                                          count, wanted.numbers(count), limits::table_values));
    }
    return wanted;
}

void scale_colors(ParticleTable& table, std::span<const Scalar> types) {
    const auto unit = [](Scalar type) {
        return type == Scalar::u8 ? 1.0 / 255 : type == Scalar::u16 ? 1.0 / 65535 : 1.0;
    };
    const auto column = [&](std::string_view name) {
        return std::size_t(std::ranges::find(table.columns, name, &ParticleColumn::name) -
                           table.columns.begin());
    };
    for (const char* part : {"r", "g", "b"}) {
        const std::size_t at = column(part);
        if (at == table.columns.size() || unit(types[at]) == 1) return;
    }
    for (const char* part : {"r", "g", "b", "a"}) {
        const std::size_t at = column(part);
        if (at == table.columns.size()) continue;
        auto& values = table.columns[at].values;
        if (auto* raw = std::get_if<RawColumn>(&values)) {
            raw->unit = unit(types[at]);
        } else {
            for (double& number : std::get<std::vector<double>>(values)) number *= unit(types[at]);
        }
    }
}

std::string place(const ParticleTable& table, const std::filesystem::path& file, std::size_t column,
                  std::size_t row) {
    if (!table.lines.empty()) return fmt::format("{}:{}", shown(file), table.lines[row]);
    const auto* raw = std::get_if<RawColumn>(&table.columns[column].values);
    if (!raw || !raw->file) return fmt::format("{}: particle {}", shown(file), row + 1);
    return fmt::format("{}: byte {}: particle {}", shown(file),
                       std::size_t(raw->first - raw->file) + row * raw->stride, row + 1);
}

std::vector<double> take_numbers(ParticleTable& table, const std::filesystem::path& file,
                                 std::size_t column) {
    ParticleColumn& from = table.columns[column];
    if (auto* numbers = std::get_if<std::vector<double>>(&from.values)) return std::move(*numbers);
    const RawColumn& raw = std::get<RawColumn>(from.values);
    std::vector<double> numbers = decoded<double>(raw, table.count);
    if (raw.unit != 1) {
        for (double& number : numbers) number *= raw.unit;
    }
    // A sum over all tells at once, in most files.
    double sum = 0;
    for (const double number : numbers) sum += number * 0;
    if (sum == 0) return numbers;
    const auto wrong = std::ranges::find_if(numbers, [](double x) { return !std::isfinite(x); });
    throw SceneError(fmt::format("{}: {}: '{}' is not a finite number",
                                 place(table, file, column, std::size_t(wrong - numbers.begin())),
                                 from.name, *wrong));
}

std::vector<std::int64_t>
take_whole_numbers(ParticleTable& table, const std::filesystem::path& file, std::size_t column) {
    const auto fail = [&](std::size_t row, double value) {
        throw SceneError(fmt::format("{}: {}: '{}' must be a whole number",
                                     place(table, file, column, row), table.columns[column].name,
                                     value));
    };
    const auto* raw = std::get_if<RawColumn>(&table.columns[column].values);
    if (raw && is_whole(raw->type)) {
        std::vector<std::int64_t> values = decoded<std::int64_t>(*raw, table.count);
        if (raw->type != Scalar::u64) return values;
        const auto wrong = std::ranges::find_if(values, [](std::int64_t x) { return x < 0; });
        if (wrong != values.end())
            fail(std::size_t(wrong - values.begin()), double(std::uint64_t(*wrong)));
        return values;
    }
    const std::vector<double> numbers = take_numbers(table, file, column);
    std::vector<std::int64_t> values(numbers.size());
    for (std::size_t row = 0; row < numbers.size(); ++row) {
        const double value = numbers[row];
        if (value != std::floor(value) || std::abs(value) > 0x1p53) fail(row, value);
        values[row] = std::int64_t(value);
    }
    return values;
}

} // namespace isomotion::scene
