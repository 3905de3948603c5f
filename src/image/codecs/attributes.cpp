#include "attributes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "image/encode.h"

namespace isomotion::image::oiio {
namespace {

void check_name(const std::string& name, std::size_t longest) {
    if (name.empty() || name.size() > longest)
        throw ImageError(fmt::format("metadata \"{}\": a name has 1 to {} bytes", name, longest));
}

// Adds one value under a fixed name.
struct Adder {
    OIIO::ImageSpec& spec;
    const std::string& name;

    void operator()(const std::string& text) const { spec.attribute(name, text); }
    void operator()(int number) const { spec.attribute(name, number); }
    void operator()(double number) const { spec.attribute(name, OIIO::TypeDesc::DOUBLE, &number); }
    void operator()(const Rational& ratio) const {
        constexpr auto top = std::numeric_limits<int>::max();
        if (ratio.numerator < -top || ratio.numerator > top || ratio.denominator < 1 ||
            ratio.denominator > top)
            throw ImageError(fmt::format("metadata {}: {} is not a ratio of 32-bit integers with a "
                                         "positive denominator",
                                         name, to_text(ratio)));
        const std::array pair{int(ratio.numerator), int(ratio.denominator)};
        spec.attribute(name, OIIO::TypeRational, pair.data());
    }
    // OpenImageIO drops arrays of doubles when it writes EXR.
    void operator()(const std::vector<double>& numbers) const {
        spec.attribute(name, to_text(numbers));
    }
};

// The numbers of `[0.1, 2]`, or nothing if the text is anything else.
std::optional<std::vector<double>> parsed_list(std::string_view text) {
    if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
    text = text.substr(1, text.size() - 2);
    std::vector<double> numbers;
    while (!text.empty()) {
        if (!numbers.empty()) {
            if (!text.starts_with(", ")) return std::nullopt;
            text.remove_prefix(2);
        }
        double number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc{}) return std::nullopt;
        numbers.push_back(number);
        text.remove_prefix(std::size_t(end - text.data()));
    }
    return numbers;
}

std::optional<Value> value_of(const OIIO::ParamValue& attribute) {
    const OIIO::TypeDesc type = attribute.type();
    if (type == OIIO::TypeString) {
        std::string text = attribute.get_string();
        if (auto numbers = parsed_list(text)) return *std::move(numbers);
        return text;
    }
    if (type == OIIO::TypeRational) {
        const int* pair = static_cast<const int*>(attribute.data());
        return Rational{pair[0], pair[1]};
    }
    if (type == OIIO::TypeInt) return attribute.get_int();
    if (type == OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE))
        return *static_cast<const double*>(attribute.data());
    if (type == OIIO::TypeFloat) return double(attribute.get_float());
    return std::nullopt;
}

bool describes_file(const OIIO::ParamValue& attribute) {
    static constexpr std::array<std::string_view, 7> names{
        "compression",        "PixelAspectRatio",  "ResolutionUnit", "XResolution",
        "screenWindowCenter", "screenWindowWidth", "YResolution"};
    const std::string_view name(attribute.name().c_str(), attribute.name().size());
    if (name == "DateTime") return attribute.get_string() == no_date;
    return name.starts_with("oiio:") || name.starts_with("openexr:") || name.starts_with("png:") ||
           std::ranges::find(names, name) != names.end();
}

} // namespace

void add_typed(OIIO::ImageSpec& spec, const Metadata& metadata) {
    for (const Entry& entry : metadata) {
        check_name(entry.name, longest_name(Format::exr));
        std::visit(Adder{spec, entry.name}, entry.value);
    }
}

void add_as_text(OIIO::ImageSpec& spec, const Metadata& metadata) {
    for (const Entry& entry : metadata) {
        check_name(entry.name, longest_name(Format::png8));
        spec.attribute(entry.name, to_text(entry.value));
    }
}

Metadata entries_of(const OIIO::ImageSpec& spec) {
    Metadata metadata;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        if (describes_file(attribute)) continue;
        if (auto value = value_of(attribute))
            metadata.push_back({attribute.name().string(), *std::move(value)});
    }
    return metadata;
}

} // namespace isomotion::image::oiio
