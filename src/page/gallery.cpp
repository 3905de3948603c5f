#include "page/gallery.h"

#include <algorithm>

#include <fmt/format.h>

#include "page/embedded_files.h"
#include "page/html.h"

namespace isomotion::page {

std::string without_place_in_file(const std::string& message, const std::string& file) {
    const std::size_t path = message.find(file + ':');
    if (path == message.npos) return message;
    std::size_t rest = path + file.size() + 1;
    const std::size_t line = message.find_first_not_of("0123456789", rest);
    if (line != message.npos && line > rest && message[line] == ':') rest = line + 1;
    return message.substr(std::min(message.find_first_not_of(' ', rest), message.size()));
}

std::string gallery_index(const std::vector<GalleryEntry>& entries,
                          const std::vector<std::string>& left_out) {
    std::string cards, rest;
    for (const GalleryEntry& entry : entries) {
        cards += fmt::format("<a href=\"{0}\"><img src=\"{1}\" alt=\"\" loading=\"lazy\" "
                             "width=\"256\" height=\"256\"><span>{2}</span></a>\n",
                             link_to(entry.name + ".html"), link_to(entry.name + ".png"),
                             html_text(entry.title));
    }
    for (const std::string& line : left_out) rest += fmt::format("<li>{}</li>\n", html_text(line));
    if (!rest.empty()) rest = fmt::format("<h2>Without a page</h2>\n<ul>\n{}</ul>\n", rest);
    return filled(embedded_files().at("gallery.html"),
                  {{"cards", cards}, {"rest", rest}, {"count", std::to_string(entries.size())}});
}

} // namespace isomotion::page
