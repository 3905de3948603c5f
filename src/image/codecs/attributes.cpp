#include "attributes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace isomotion::image::oiio {
namespace {

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
    // Files of earlier versions have this date where their metadata had none.
    if (name == "DateTime") return attribute.get_string() == "1970:01:01 00:00:00";
    return name.starts_with("oiio:") || name.starts_with("openexr:") || name.starts_with("png:") ||
           std::ranges::find(names, name) != names.end();
}

} // namespace

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
