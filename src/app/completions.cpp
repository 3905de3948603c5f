#include "app/completions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isomotion::app {
namespace {

using Names = std::vector<std::string>;

constexpr const char* continued = " \\\n                "; // on the script's next line

// Puts a text in single quotes, as all three shells read them.
std::string quoted(const std::string& text) {
    std::string all = "'";
    for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return all + "'";
}

Names names_of(const std::vector<CommandText>& commands) {
    Names names;
    for (const CommandText& command : commands) names.push_back(command.name);
    return names;
}

Names names_of(const std::vector<OptionText>& options) {
    Names names;
    for (const OptionText& option : options) {
        if (option.positional) continue;
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return names;
}

bool is_scene(const OptionText& option) {
    return option.positional && option.names.front() == "scene";
}

// The line of a bash `case` that completes the value of an option.
std::string bash_value(const CommandText& command, const OptionText& option) {
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) {
        patterns.push_back(fmt::format("{}:{}", command.name, name));
    }
    const std::string words = option.choices.empty()
                                  ? R"(COMPREPLY=($(compgen -f -- "$word")))"
                                  : fmt::format(R"(COMPREPLY=($(compgen -W "{}" -- "$word")))",
                                                fmt::join(option.choices, " "));
    return fmt::format("        {}) {}; return ;;\n", fmt::join(patterns, "|"), words);
}

// An explanation in the brackets of a specification for _arguments.
std::string bracketed(const std::string& text) {
    std::string all = "[";
    for (const char c : text) {
        if (c == '[' || c == ']' || c == '\\') all += '\\';
        all += c;
    }
    return all + "]";
}

std::string zsh_option(const OptionText& option) {
    const std::string values =
        option.choices.empty() ? "_files" : fmt::format("({})", fmt::join(option.choices, " "));
    if (option.positional) {
        return quoted(fmt::format("{}:{}:{}", option.required ? "1" : "1:", option.names.front(),
                                  is_scene(option) ? "_isomotion_scenes" : values));
    }
    std::string all;
    for (const std::string& name : option.names) {
        if (!all.empty()) all += continued;
        all += quoted(
            fmt::format("*{}{}{}", name, bracketed(option.description),
                        option.value.empty() ? "" : fmt::format(":{}:{}", option.value, values)));
    }
    return all;
}

} // namespace

std::string bash_completion(const CommandTree& tree, const Names& scenes) {
    std::string values, options, arguments;
    for (const CommandText& command : tree.commands) {
        options += fmt::format("        {}) options=\"{}\" ;;\n", command.name,
                               fmt::join(names_of(command.options), " "));
        for (const OptionText& option : command.options) {
            if (is_scene(option)) {
                arguments +=
                    fmt::format("        {}) words=\"$scenes\"; files=true ;;\n", command.name);
            } else if (option.positional) {
                arguments += fmt::format("        {}) words=\"{}\" ;;\n", command.name,
                                         fmt::join(option.choices, " "));
            } else if (!option.value.empty()) {
                values += bash_value(command, option);
            }
        }
    }
    return fmt::format(R"(# bash completion of isomotion
_isomotion() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
    local command=${{COMP_WORDS[1]}} options= words= files=
    local scenes="{}"
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W "{} {}" -- "$word"))
        return
    fi
    case "$command:$before" in
{}    esac
    case "$command" in
{}    esac
    case "$command" in
{}    esac
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    else
        COMPREPLY=($(compgen -W "$words" -- "$word") ${{files:+$(compgen -f -- "$word")}})
    fi
}}
complete -o filenames -F _isomotion isomotion
)",
                       fmt::join(scenes, " "), fmt::join(names_of(tree.commands), " "),
                       fmt::join(names_of(tree.options), " "), values, options, arguments);
}

std::string zsh_completion(const CommandTree& tree, const Names& scenes) {
    std::string commands, cases;
    for (const CommandText& command : tree.commands) {
        commands += fmt::format("        {}\n", quoted(command.name + ":" + command.description));
        cases += fmt::format("            {})\n            _arguments -s", command.name);
        for (const OptionText& option : command.options) {
            cases += continued + zsh_option(option);
        }
        cases += "\n            ;;\n";
    }
    return fmt::format(R"(#compdef isomotion
# zsh completion of isomotion
_isomotion_scenes() {{
    local -a scenes=({})
    _alternative 'scenes:scene of the gallery:compadd -a scenes' 'files:scene file:_files -g "*.toml"'
}}
_isomotion() {{
    local -a commands=(
{}    )
    local state line
    _arguments -C {} '1: :->command' '*:: :->arguments'
    case $state in
    command) _describe command commands ;;
    arguments)
        case $line[1] in
{}        esac
        ;;
    esac
}}
_isomotion "$@"
)",
                       fmt::join(scenes, " "), commands, fmt::join(names_of(tree.options), " "),
                       cases);
}

std::string fish_completion(const CommandTree& tree, const Names& scenes) {
    std::string text = "# fish completion of isomotion\ncomplete -c isomotion -f\n";
    const auto add = [&](const std::string& condition, const std::string& rest) {
        text += fmt::format("complete -c isomotion -n {} {}\n", quoted(condition), rest);
    };
    const auto spelled = [](const OptionText& option) {
        std::string all;
        for (const std::string& name : option.names) {
            all += name.starts_with("--") ? "-l " + name.substr(2) : "-s " + name.substr(1);
            all += " ";
        }
        return all + "-d " + quoted(option.description);
    };
    for (const OptionText& option : tree.options) add("__fish_use_subcommand", spelled(option));
    for (const CommandText& command : tree.commands) {
        add("__fish_use_subcommand",
            fmt::format("-a {} -d {}", command.name, quoted(command.description)));
        const std::string inside = "__fish_seen_subcommand_from " + command.name;
        for (const OptionText& option : command.options) {
            const std::string choices = quoted(fmt::format("{}", fmt::join(option.choices, " ")));
            if (is_scene(option)) {
                add(inside,
                    fmt::format("-F -a {}", quoted(fmt::format("{}", fmt::join(scenes, " ")))));
            } else if (option.positional) {
                add(inside, "-a " + choices);
            } else if (option.value.empty()) {
                add(inside, spelled(option));
            } else {
                add(inside,
                    spelled(option) + (option.choices.empty() ? " -r -F" : " -x -a " + choices));
            }
        }
    }
    return text;
}

} // namespace isomotion::app
