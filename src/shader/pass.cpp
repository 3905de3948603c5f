#include "shader/pass.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "base/fingerprint.h"
#include "shader/shader_code.h"

namespace isomotion::shader {
namespace {

// Takes blanks and a name off the front of a line.
std::string_view take_name(std::string_view& line) {
    while (line.starts_with(' ')) line.remove_prefix(1);
    const auto end = std::find_if_not(line.begin(), line.end(), is_of_a_word);
    const std::string_view name = line.substr(0, std::size_t(end - line.begin()));
    line.remove_prefix(name.size());
    return name;
}

bool take(std::string_view& line, std::string_view head) {
    if (!line.starts_with(head)) return false;
    line.remove_prefix(head.size());
    return true;
}

void note(std::vector<std::string>& names, std::string_view name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
}

// One declaration a line, at its beginning, as all files of shaders/ and generated parts have it.
void note_line(std::string_view line, Pass& pass, bool is_last_stage) {
    if (take(line, "layout(std140) uniform ")) {
        note(pass.blocks, take_name(line));
    } else if (line.starts_with("uniform sampler") || line.starts_with("uniform usampler") ||
               line.starts_with("uniform IM_BUFFER")) {
        take(line, "uniform");
        take_name(line); // the type
        do {
            note(pass.samplers, take_name(line));
        } while (take(line, ","));
    } else if (is_last_stage && line.starts_with("layout(location")) {
        line.remove_prefix(std::min(line.find(')') + 1, line.size()));
        if (!take(line, " out ")) return;
        take_name(line);
        note(pass.outputs, take_name(line));
    }
}

void note_text(std::string_view text, Pass& pass, bool is_last_stage) {
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        note_line(line, pass, is_last_stage);
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
}

} // namespace

std::string_view words(When when) {
    switch (when) {
    case When::once_a_tile:
        return "once a tile";
    case When::until_rays_end:
        return "until every ray has ended";
    case When::where_fused_ends:
        return "where one draw is too few for every ray";
    case When::where_proof_is_open:
        return "where proofs in floats stay open";
    case When::at_two_times:
        return "at two times about the frame's";
    }
    return "?";
}

void note_declarations(Pass& pass) {
    note_text(pass.vertex, pass, false);
    note_text(pass.text, pass, true);
}

Passes without_fused_pass(Passes passes) {
    passes.fuses = false;
    std::erase_if(passes.list, [](const Pass& pass) {
        return pass.role == Role::mask || pass.role == Role::fused || pass.role == Role::settled;
    });
    for (Pass& pass : passes.list) {
        if (pass.when != When::where_fused_ends) continue;
        const bool marches = pass.role == Role::march || pass.role == Role::active;
        pass.when = marches ? When::until_rays_end : When::once_a_tile;
    }
    return passes;
}

std::optional<int> PassPlan::attachment(Channel channel) const {
    const auto at = std::ranges::find(attachments, channel);
    if (at == attachments.end()) return std::nullopt;
    return 2 + int(at - attachments.begin());
}

const Pass* Passes::find(Role role, int level) const {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Pass& pass) {
        return pass.role == role && pass.level == level;
    });
    return found == list.end() ? nullptr : &*found;
}

const Pass& Passes::at(Role role, int level) const {
    if (const Pass* pass = find(role, level)) return *pass;
    throw std::logic_error(
        fmt::format("the scene has no pass of role {} and level {}", int(role), level));
}

std::vector<std::string> Passes::files() const {
    std::vector<std::string> all;
    for (const Pass& pass : list) {
        for (const std::string& file : pass.files) note(all, file);
    }
    return all;
}

std::string Passes::fingerprint() const {
    base::Fingerprint print;
    for (const Pass& pass : list)
        print.add(pass.name).add(code_of(pass.vertex)).add(code_of(pass.text));
    return print.text();
}

} // namespace isomotion::shader
