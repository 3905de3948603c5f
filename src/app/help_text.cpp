#include "app/help_text.h"

#include <algorithm>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/examples.h"

namespace isomotion::app {
namespace {

constexpr std::size_t names_width = 34, text_width = 66; // a line has 100 columns

// Broken at spaces.
std::string wrapped(const std::string& text) {
    std::string all;
    std::size_t column = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::size_t size = end - begin;
        if (column > 0) {
            const bool fits = column + 1 + size <= text_width;
            all += fits ? ' ' : '\n';
            column = fits ? column + 1 : 0;
        }
        all.append(text, begin, size);
        column += size;
        begin = end + 1;
    }
    return all;
}

class WithExample : public CLI::Formatter {
public:
    std::string make_option_desc(const CLI::Option* option) const override {
        return wrapped(CLI::Formatter::make_option_desc(option));
    }
    // "--paused", not "--paused{false}".
    std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
        std::string name = CLI::Formatter::make_option_name(option, is_positional);
        const std::size_t begin = name.find('{');
        if (begin != name.npos && name.find('}', begin) != name.npos)
            name.erase(begin, name.find('}', begin) + 1 - begin);
        return name;
    }
    std::string make_description(const CLI::App* app) const override {
        std::string plain = CLI::Formatter::make_description(app);
        const Example* example = app->get_parent() ? example_of(app->get_name()) : nullptr;
        if (!example) return plain;
        return fmt::format("{}\n    {}\n\n{}", example->line, example->what, plain);
    }
};

} // namespace

void write_help_with_examples(CLI::App& app) {
    const auto formatter = std::make_shared<WithExample>();
    formatter->column_width(names_width);
    app.formatter(formatter);
}

} // namespace isomotion::app
