#include "scene/particles/xml_tags.h"

#include <algorithm>

namespace isomotion::scene {
namespace {

constexpr std::string_view between = " \t\r\n";

} // namespace

std::string_view XmlTag::attribute(std::string_view wanted) const {
    for (const auto& [key, value] : attributes) {
        if (key == wanted) return value;
    }
    return {};
}

void XmlTags::fail(const std::string& message) const { fail_at_byte(request_, at_, message); }

void XmlTags::skip_blanks() {
    while (at_ < text_.size() && between.find(text_[at_]) != between.npos) ++at_;
}

std::string_view XmlTags::name() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(" \t\r\n=/>", at_), text_.size());
    if (at_ == begin) fail("a name must be here");
    return text_.substr(begin, at_ - begin);
}

void XmlTags::read_attributes(XmlTag& tag) {
    constexpr std::size_t most = 100;
    for (;;) {
        skip_blanks();
        if (at_ >= text_.size()) fail("the file ends in a tag");
        if (text_[at_] == '>') break;
        if (text_.substr(at_).starts_with("/>")) {
            tag.is_whole = true;
            ++at_;
            break;
        }
        const std::string_view key = name();
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != '=') fail("an attribute needs a '=' here");
        ++at_;
        skip_blanks();
        const char quote = at_ < text_.size() ? text_[at_] : ' ';
        if (quote != '"' && quote != '\'') fail("an attribute needs a text in quotes here");
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == text_.npos) fail("the text has no end");
        if (tag.attributes.size() == most) fail("a tag has more than 100 attributes");
        tag.attributes.emplace_back(key, text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
    }
    ++at_;
}

std::optional<XmlTag> XmlTags::next() {
    for (;;) {
        at_ = std::min(text_.find('<', at_), text_.size());
        if (at_ == text_.size()) return std::nullopt;
        const std::string_view here = text_.substr(at_);
        const std::string_view end = here.starts_with("<!--") ? "-->"
                                     : here.starts_with("<?") ? "?>"
                                                              : "";
        if (end.empty()) break;
        const std::size_t after = text_.find(end, at_ + 2);
        if (after == text_.npos) fail("the comment has no end");
        at_ = after + end.size();
    }
    XmlTag tag;
    tag.at = at_++;
    if (at_ < text_.size() && text_[at_] == '/') {
        tag.begins = false;
        ++at_;
    }
    tag.name = name();
    read_attributes(tag);
    tag.end = at_;
    return tag;
}

std::size_t XmlTags::end_of_text() const { return std::min(text_.find('<', at_), text_.size()); }

} // namespace isomotion::scene
