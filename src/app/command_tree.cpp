#include "app/command_tree.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "gpu/context.h"
#include "scene/method.h"
#include "shader/channel.h"

namespace isomotion::app {
namespace {

std::vector<std::string> names_of(const auto& entries) {
    std::vector<std::string> names;
    names.reserve(std::size(entries));
    for (const auto& entry : entries) names.emplace_back(entry.name);
    return names;
}

// "a", "b" of "TEXT:{a,b}", as CLI11 describes a choice that it checks itself.
std::vector<std::string> checked_choices(const std::string& type) {
    const std::size_t open = type.find('{');
    if (open == std::string::npos || !type.ends_with('}')) return {};
    std::vector<std::string> choices;
    for (std::size_t begin = open + 1; begin < type.size();) {
        const std::size_t end = type.find_first_of(",}", begin);
        choices.push_back(type.substr(begin, end - begin));
        begin = end + 1;
    }
    return choices;
}

// What our own parsers check.
std::vector<std::string> known_choices(const std::string& command, const std::string& option) {
    if (option == "--backend") {
        std::vector<std::string> choices;
        for (const auto backend : {gpu::Backend::automatic, gpu::Backend::egl, gpu::Backend::osmesa,
                                   gpu::Backend::glfw}) {
            choices.emplace_back(gpu::name(backend));
        }
        return choices;
    }
    if (option == "--method" || option == "--methods") return names_of(scene::method_traits);
    if (option == "--stage") return {"fragment", "compute", "auto"};
    if (option == "--channels") return names_of(shader::channel_names());
    if (option == "--certify" && command == "topology") return {"off", "fast", "full"};
    return {};
}

OptionText text_of(const std::string& command, const CLI::Option& option) {
    OptionText text;
    text.positional = option.get_positional();
    text.required = option.get_required();
    text.description = option.get_description();
    if (text.positional) {
        text.names = {option.get_name(true)};
    } else {
        for (const auto& name : option.get_snames()) text.names.push_back("-" + name);
        for (const auto& name : option.get_lnames()) text.names.push_back("--" + name);
    }
    if (option.get_items_expected_max() > 0) {
        const std::string type = option.get_type_name();
        text.value = type.substr(0, type.find(':'));
        text.choices = checked_choices(type);
        if (text.choices.empty()) text.choices = known_choices(command, text.names.back());
    }
    return text;
}

std::vector<OptionText> options_of(const CLI::App& app) {
    std::vector<OptionText> all;
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_group().empty()) all.push_back(text_of(app.get_name(), *option));
    }
    std::stable_partition(all.begin(), all.end(),
                          [](const OptionText& option) { return option.positional; });
    return all;
}

} // namespace

CommandTree command_tree(const CLI::App& app) {
    CommandTree tree{app.get_name(), app.get_description(), options_of(app), {}};
    const auto shown = [](const CLI::App* command) { return !command->get_group().empty(); };
    for (const CLI::App* command : app.get_subcommands(shown)) {
        tree.commands.push_back(
            {command->get_name(), command->get_description(), options_of(*command)});
    }
    return tree;
}

} // namespace isomotion::app
