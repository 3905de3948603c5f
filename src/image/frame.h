#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <isomotion/error.h>

namespace isomotion::image {

/// The content of a frame or of a file is invalid. Refusals of the file system are FileErrors
/// instead.
class ImageError : public Error {
public:
    explicit ImageError(const std::string& message)
        : Error(Code::input, message) {}
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

/// Data about a frame besides its pixels, in the order in which it was added. Files keep every
/// entry, but not always the order.
using Metadata = std::vector<Entry>;

/// The value of that name, or null.
const Value* find(const Metadata& metadata, std::string_view name);

/// A value as text that parses to the same value: the shortest decimals that round-trip,
/// `30000/1001`, `[0.1, 2]`.
std::string to_text(const Value& value);

/// One number per pixel: row by row, the top row first.
struct Channel {
    std::string name;
    std::vector<float> samples;
};

/// A picture as named channels. `R`, `G`, `B` are linear light premultiplied by the coverage `A`.
/// Other names in use are `Z`, `N.X N.Y N.Z`, `P.X P.Y P.Z`, `verdict` and `evaluations`.
struct Frame {
    int width = 0;
    int height = 0;
    std::vector<Channel> channels;
    Metadata metadata;

    /// The channel of that name, or null.
    const Channel* find(std::string_view name) const;
};

/// The number of pixels whose colour or coverage is infinite or NaN.
std::int64_t count_without_colour(const Frame& frame);

/// Throws an ImageError unless the frame has an area, and channels of that area with distinct
/// names.
void check(const Frame& frame);

} // namespace isomotion::image
