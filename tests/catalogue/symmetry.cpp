#include "symmetry.h"

#include <map>
#include <numbers>
#include <regex>
#include <stdexcept>

#include <glm/gtc/matrix_transform.hpp>

namespace isomotion::catalogue {
namespace {

glm::dmat3 turn(double angle, const glm::dvec3& axis) {
    return glm::dmat3(glm::rotate(glm::dmat4(1), angle, axis));
}

glm::dvec3 axis_named(char name) {
    glm::dvec3 axis(0);
    axis[name - 'x'] = 1;
    return axis;
}

glm::dmat3 reflection(char axis) {
    glm::dmat3 map(1);
    map[axis - 'x'] *= -1;
    return map;
}

glm::dmat3 exchange(char a, char b) {
    glm::dmat3 map(1);
    std::swap(map[a - 'x'], map[b - 'x']);
    return map;
}

} // namespace

std::vector<glm::dmat3> maps_of(const std::string& generator) {
    using std::numbers::pi, std::numbers::phi;
    static const std::map<std::string, glm::dmat3> named{
        {"inversion", glm::dmat3(-1)},
        {"xyz cyclic", {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},
        {"x<->y, z->-z", exchange('x', 'y') * reflection('z')},
        {"C5(icosahedral b)", turn(2 * pi / 5, {1, 0, phi})}};
    if (const auto found = named.find(generator); found != named.end()) return {found->second};

    std::smatch part;
    const auto is = [&](const char* pattern) {
        return std::regex_match(generator, part, std::regex(pattern));
    };
    const auto axis = [&](std::size_t k) { return part[int(k)].str()[0]; };
    if (is("([xyz])->-\\1")) return {reflection(axis(1))};
    if (is("([xyz])<->([xyz])")) return {exchange(axis(1), axis(2))};
    if (is("C([2-9])\\(([xyz])\\)")) {
        return {turn(2 * pi / std::stoi(part[1].str()), axis_named(axis(2)))};
    }
    if (is("S4\\(([xyz])\\)")) return {reflection(axis(1)) * turn(pi / 2, axis_named(axis(1)))};
    if (is("revolution\\(([xyz])\\)")) {
        std::vector<glm::dmat3> maps;
        for (const double angle : {0.3, 1.1, 2.5}) maps.push_back(turn(angle, axis_named(axis(1))));
        return maps;
    }
    throw std::invalid_argument("no generator '" + generator + "'");
}

} // namespace isomotion::catalogue
