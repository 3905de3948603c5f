#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace isomotion::image {

/// What a frame holds, or what the bytes of a file mean, is not acceptable. What the file system
/// refuses is a FileError instead.
class ImageError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Rational {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;

    bool operator==(const Rational&) const = default;
};

using Value = std::variant<std::string, int, double, Rational, std::vector<double>>;

struct Entry {
    std::string name;
    Value value;

    bool operator==(const Entry&) const = default;
};

/// What is known about a frame beside its pixels, in the order it was added. Files keep every
/// entry, but not always the order.
using Metadata = std::vector<Entry>;

/// The value of that name, or null.
const Value* find(const Metadata& metadata, std::string_view name);

/// A value as text that gives the same value again when it is parsed: the shortest decimals that
/// round-trip, `30000/1001`, `[0.1, 2]`.
std::string to_text(const Value& value);

/// One number for each pixel: row by row, the top row first.
struct Channel {
    std::string name;
    std::vector<float> samples;
};

/// A picture as named channels. `R`, `G`, `B` are linear light multiplied by the coverage `A`;
/// other names in use are `Z`, `N.X N.Y N.Z`, `P.X P.Y P.Z`, `verdict` and `evaluations`.
struct Frame {
    int width = 0;
    int height = 0;
    std::vector<Channel> channels;
    Metadata metadata;

    /// The channel of that name, or null.
    const Channel* find(std::string_view name) const;
};

/// How many pixels have a colour or coverage that is infinite or no number.
std::int64_t count_without_colour(const Frame& frame);

/// Throws an ImageError unless the frame has an area and channels of that area with distinct names.
void check(const Frame& frame);

} // namespace isomotion::image
