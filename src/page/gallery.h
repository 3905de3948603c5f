// Pages of all animations and an index of them: a folder of static files.
#pragma once

#include <string>
#include <vector>

namespace isomotion::page {

// A page of the gallery.
struct GalleryEntry {
    std::string name; // of its files: name.html, name.png
    std::string title;
};

// index.html: a poster for each page. `left_out`: a line for each animation without a page, with
// the reason.
std::string gallery_index(const std::vector<GalleryEntry>& entries,
                          const std::vector<std::string>& left_out);

// A message "path/file:line: rest" without its beginning, which tells where files lie here; the
// line may be missing.
std::string without_place_in_file(const std::string& message, const std::string& file);

} // namespace isomotion::page
