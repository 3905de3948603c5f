#include "app/help_text.h"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/examples.h"

namespace isomotion::app {
namespace {

class WithExample : public CLI::Formatter {
public:
    std::string make_description(const CLI::App* app) const override {
        const std::string plain = CLI::Formatter::make_description(app);
        const Example* example = app->get_parent() ? example_of(app->get_name()) : nullptr;
        if (!example) return plain;
        return fmt::format("{}\n    {}\n\n{}", example->line, example->what, plain);
    }
};

} // namespace

void write_help_with_examples(CLI::App& app) {
    const auto formatter = std::make_shared<WithExample>();
    formatter->column_width(34);
    app.formatter(formatter);
}

} // namespace isomotion::app
