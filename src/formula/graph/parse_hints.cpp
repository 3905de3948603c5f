#include "formula/graph/parse_hints.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"

namespace isomotion::formula {
namespace {

// "x*y" for "xy", where x and y are known; else empty.
std::string as_product(std::string_view word, const std::vector<std::string>& known) {
    constexpr std::size_t longest = 4;
    std::string product;
    for (const char c : word) {
        const std::string letter(1, c);
        const bool is_again = product.find(c) != product.npos;
        if (is_again || std::ranges::count(known, letter) == 0) return "";
        product += (product.empty() ? "" : "*") + letter;
    }
    return word.size() > 1 && word.size() <= longest ? product : "";
}

} // namespace

std::string hint_for_unknown(std::string_view name, const std::vector<std::string>& known) {
    const std::string product = as_product(name, known);
    if (!product.empty()) return fmt::format("; a product is written '{}'", product);
    if (name == "t")
        return "; time moves parameters: name one here, as T, and write T = \"t\" under "
               "[parameters]";
    if (name == "theta") return "; write atan2(y, x) for an angle about the z axis";
    const std::string near = base::nearest_name(name, known);
    return near.empty() ? fmt::format("; known: {}", fmt::join(known, ", "))
                        : fmt::format("; did you mean '{}'?", near);
}

std::string_view hint_for_sign(std::string_view sign) {
    const bool compares = sign == "<" || sign == ">" || sign == "≤" || sign == "≥";
    if (compares) return ": a comparison has a value on either side: a < b, a <= b";
    return sign == "%" ? ": write mod(a, b) for the rest of a/b" : "";
}

} // namespace isomotion::formula
