// A picture's elements, for tests of what it shows.
//
// Not by std::regex, which calls itself for each letter: a path of 2,000 ticks is more than the
// stack holds under the sanitizers.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace isomotion::topology {

struct SvgElement {
    std::string name, words; // what stands between it and the next tag
    std::map<std::string, std::string> attributes;

    const std::string& operator[](const std::string& attribute) const {
        return attributes.at(attribute);
    }
    double number(const std::string& attribute) const {
        return std::stod(attributes.at(attribute));
    }
    bool is(const std::string& tag, const std::string& attribute, const std::string& value) const {
        const auto found = attributes.find(attribute);
        return name == tag && found != attributes.end() && found->second == value;
    }
};

// The elements in order; expects each to be closed, in order, and no stray < or >.
std::vector<SvgElement> elements_of(const std::string& svg);

// A path's steps: M10 20h4V7z is M with two numbers, h with one, V with one, z.
struct PathStep {
    char letter;
    std::vector<double> numbers;
};
std::vector<PathStep> steps_of(const std::string& d);

} // namespace isomotion::topology
