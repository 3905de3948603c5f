// Text and data in an HTML file, where no title and no formula can end an element.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace isomotion::page {

// Text between tags or in quotes.
std::string html_text(std::string_view text);

// `html` with a part in place of each {{name}}; what parts hold is left as it is. Throws
// std::logic_error for a name that has none.
std::string filled(std::string_view html, const std::map<std::string_view, std::string>& parts);

// Deflated (zlib's format, which browsers take apart) and as letters.
std::string deflated_text(std::span<const std::byte> bytes);

} // namespace isomotion::page
