#include "scene/reading/isolation.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "scene/limits.h"

namespace isomotion::scene {

void read_isolation(Section& document, Isolation& isolation, GivenThresholds& given) {
    auto section = document.section("isolation");
    if (!section) return;
    if (const auto text = section->text("method")) {
        const auto method = parse_method(*text);
        if (!method) {
            std::vector<std::string> names;
            for (const auto& entry : method_traits) names.emplace_back(entry.name);
            fail(*section->find("method"), "isolation.method",
                 fmt::format("there is no method '{}'; known: {}", *text, fmt::join(names, ", ")));
        }
        isolation.method = *method;
    }
    const auto set = [&](const char* name, double least, double& value, bool& known) {
        if (const auto number = section->number(name, least, 1e30)) {
            value = *number;
            known = true;
        }
    };
    set("step", 1e-30, isolation.step, given.step);
    set("near", 0, isolation.near, given.near);
    set("far", 0, isolation.far, given.far);
    set("horizon", 0, isolation.horizon, given.horizon);
    isolation.bisections =
        section->integer("bisections", 0, limits::bisections).value_or(isolation.bisections);
    if (const auto beam = section->boolean("beam")) isolation.beam = *beam;
    isolation.certify = section->boolean("certify").value_or(isolation.certify);
    isolation.safety = section->number("safety", 1, 1e6).value_or(isolation.safety);
    isolation.limit = section->integer("limit", 1, limits::evaluations).value_or(isolation.limit);
    section->refuse_rest();
}

} // namespace isomotion::scene
