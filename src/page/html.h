// Puts text and data into an HTML file so that no title or formula can end an element.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace isomotion::page {

// Text between tags or in quotes.
std::string html_text(std::string_view text);

// A link to a file beside the page, whatever its name: no name is taken for another scheme
// ("javascript:"), a query or a fragment.
std::string link_to(std::string_view file);

// `html` with each {{name}} replaced by its part; the parts themselves are not searched. Throws
// std::logic_error for a name without a part.
std::string filled(std::string_view html, const std::map<std::string_view, std::string>& parts);

// Deflated (zlib's format, which browsers can inflate) and encoded as text.
std::string deflated_text(std::span<const std::byte> bytes);

} // namespace isomotion::page
