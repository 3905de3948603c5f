#include "page/html.h"

#include <new>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "base/base64.h"

namespace isomotion::page {

std::string html_text(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        case '\'':
            safe += "&#39;";
            break;
        default:
            safe += c;
        }
    }
    return safe;
}

std::string link_to(std::string_view file) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                       "0123456789-._~";
    std::string link = "./";
    for (const char c : file) {
        if (plain.find(c) != plain.npos) {
            link += c;
        } else {
            link += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return link;
}

std::string filled(std::string_view html, const std::map<std::string_view, std::string>& parts) {
    std::string text;
    while (true) {
        const std::size_t open = html.find("{{"), close = html.find("}}");
        if (open == html.npos || close == html.npos) return text.append(html);
        const std::string_view name = html.substr(open + 2, close - open - 2);
        const auto part = parts.find(name);
        if (part == parts.end()) throw std::logic_error(fmt::format("no part {}", name));
        text.append(html.substr(0, open)).append(part->second);
        html.remove_prefix(close + 2);
    }
}

std::string deflated_text(std::span<const std::byte> bytes) {
    uLongf length = compressBound(uLong(bytes.size()));
    std::vector<std::byte> deflated(length);
    const auto* from = reinterpret_cast<const Bytef*>(bytes.data());
    auto* to = reinterpret_cast<Bytef*>(deflated.data());
    if (compress2(to, &length, from, uLong(bytes.size()), Z_BEST_COMPRESSION) != Z_OK)
        throw std::bad_alloc();
    return base::base64(std::span(deflated).first(length));
}

} // namespace isomotion::page
