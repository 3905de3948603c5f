// The tags of an XML file, in order; the texts between them are skipped.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

struct XmlTag {
    std::string_view name;
    bool begins = true;    // not </name>
    bool is_whole = false; // <name/>
    std::size_t at = 0;    // its first byte
    std::size_t end = 0;   // the byte after it

    // Empty if there is no such attribute.
    std::string_view attribute(std::string_view attribute) const;

    std::vector<std::pair<std::string_view, std::string_view>> attributes{};
};

class XmlTags {
public:
    XmlTags(const ParticleRequest& request, std::string_view text)
        : request_(request)
        , text_(text) {}

    // None at the end.
    std::optional<XmlTag> next();
    // Where the text after the last tag read ends.
    std::size_t end_of_text() const;

private:
    void read_attributes(XmlTag& tag);
    std::string_view name();
    void skip_blanks();
    [[noreturn]] void fail(const std::string& message) const;

    const ParticleRequest& request_;
    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace isomotion::scene
