// The files of src/page/web/, by their names.
#pragma once

#include <map>
#include <string_view>

namespace isomotion::page {

std::map<std::string_view, std::string_view> embedded_files();

} // namespace isomotion::page
