#include "page/gallery.h"

#include <fmt/format.h>

#include "page/embedded_files.h"
#include "page/html.h"

namespace isomotion::page {

std::string gallery_index(const std::vector<GalleryEntry>& entries,
                          const std::vector<std::string>& left_out) {
    std::string cards, rest;
    for (const GalleryEntry& entry : entries) {
        cards += fmt::format("<a href=\"{0}.html\"><img src=\"{0}.png\" alt=\"\" loading=\"lazy\" "
                             "width=\"256\" height=\"256\"><span>{1}</span></a>\n",
                             html_text(entry.name), html_text(entry.title));
    }
    for (const std::string& line : left_out) rest += fmt::format("<li>{}</li>\n", html_text(line));
    if (!rest.empty()) rest = fmt::format("<h2>Without a page</h2>\n<ul>\n{}</ul>\n", rest);
    return filled(embedded_files().at("gallery.html"),
                  {{"cards", cards}, {"rest", rest}, {"count", std::to_string(entries.size())}});
}

} // namespace isomotion::page
