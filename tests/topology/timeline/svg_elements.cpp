#include "topology/timeline/svg_elements.h"

#include <sstream>
#include <string_view>

#include <gtest/gtest.h>

namespace isomotion::topology {
namespace {

// Reads an element's name and attributes from what stands between its < and >.
SvgElement element_of(std::string_view tag) {
    constexpr std::string_view spaces = " \t\r\n";
    const auto skip = [&](std::string_view letters) {
        const std::size_t n = std::min(tag.find_first_not_of(letters), tag.size());
        tag.remove_prefix(n);
    };
    const auto word = [&](std::string_view ends) {
        const std::string found(tag.substr(0, tag.find_first_of(ends)));
        tag.remove_prefix(found.size());
        return found;
    };
    SvgElement element;
    element.name = word(spaces);
    EXPECT_EQ(element.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), std::string::npos)
        << element.name;
    EXPECT_FALSE(element.name.empty());
    for (skip(spaces); !tag.empty(); skip(spaces)) {
        const std::string name = word("=");
        if (!tag.starts_with("=\"")) {
            ADD_FAILURE() << element.name << ": " << name << " has no value in quotes";
            return element;
        }
        tag.remove_prefix(2);
        EXPECT_TRUE(element.attributes.emplace(name, word("\"")).second) << name << " stands twice";
        if (tag.empty()) {
            ADD_FAILURE() << element.name << ": " << name << " has no end";
            return element;
        }
        tag.remove_prefix(1);
    }
    return element;
}

} // namespace

std::vector<SvgElement> elements_of(const std::string& svg) {
    std::vector<SvgElement> elements;
    std::vector<std::string> open;
    std::size_t at = 0;
    while (at < svg.size() && svg[at] == '<') {
        const std::size_t end = svg.find('>', at);
        if (end == svg.npos) {
            ADD_FAILURE() << "a tag without an end: " << svg.substr(at, 80);
            return elements;
        }
        std::string_view tag(svg.data() + at + 1, end - at - 1);
        EXPECT_EQ(tag.find('<'), tag.npos) << tag;
        const std::size_t next = std::min(svg.find('<', end), svg.size());
        if (tag.starts_with("/")) {
            EXPECT_FALSE(open.empty());
            if (open.empty()) return elements;
            EXPECT_EQ(open.back(), tag.substr(1));
            open.pop_back();
        } else {
            const bool is_closed = tag.ends_with("/");
            if (is_closed) tag.remove_suffix(1);
            elements.push_back(element_of(tag));
            elements.back().words = svg.substr(end + 1, next - end - 1);
            EXPECT_EQ(elements.back().words.find('>'), std::string::npos);
            if (!is_closed) open.push_back(elements.back().name);
        }
        at = next;
    }
    EXPECT_TRUE(open.empty());
    EXPECT_TRUE(svg.starts_with("<") && svg.ends_with(">\n"));
    return elements;
}

std::vector<PathStep> steps_of(const std::string& d) {
    std::vector<PathStep> steps;
    std::istringstream in(d);
    for (char letter; in >> letter;) {
        EXPECT_TRUE(std::isalpha(letter)) << d.substr(0, 80);
        steps.push_back({letter, {}});
        for (int next = (in >> std::ws).peek(); next == '-' || next == '.' || std::isdigit(next);
             next = (in >> std::ws).peek()) {
            double number = 0;
            in >> number;
            if (!in) {
                ADD_FAILURE() << d.substr(0, 80);
                return steps;
            }
            steps.back().numbers.push_back(number);
        }
    }
    return steps;
}

} // namespace isomotion::topology
