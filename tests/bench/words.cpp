#include "words.h"

#include <CLI/CLI.hpp>

namespace isomotion::bench {

struct Words::Parser {
    CLI::App app;
};

Words::Words(const std::string& about)
    : parser_(new Parser{CLI::App(about)}) {}

Words::~Words() = default;

void Words::text(const std::string& names, std::string& to, const std::string& about) {
    parser_->app.add_option(names, to, about);
}

void Words::one_of(const std::vector<std::string>& values, const std::string& names,
                   std::string& to, const std::string& about) {
    parser_->app.add_option(names, to, about)->check(CLI::IsMember(values));
}

void Words::texts(const std::string& names, std::vector<std::string>& to,
                  const std::string& about) {
    parser_->app.add_option(names, to, about)->delimiter(',');
}

void Words::number(const std::string& names, int& to, const std::string& about) {
    parser_->app.add_option(names, to, about);
}

void Words::number(const std::string& names, int& to, const std::string& about,
                   const Range& range) {
    parser_->app.add_option(names, to, about)->check(CLI::Range(range.least, range.most));
}

void Words::number(const std::string& names, double& to, const std::string& about) {
    parser_->app.add_option(names, to, about);
}

void Words::seed(const std::string& names, std::uint64_t& to, const std::string& about) {
    parser_->app.add_option(names, to, about);
}

void Words::flag(const std::string& names, bool& to, const std::string& about) {
    parser_->app.add_flag(names, to, about);
}

void Words::folder(const std::string& names, std::filesystem::path& to, const std::string& about) {
    parser_->app
        .add_option_function<std::string>(
            names, [&to](const std::string& name) { to = name; }, about)
        ->check(CLI::ExistingDirectory);
}

void Words::require(const std::string& name) { parser_->app.get_option(name)->required(); }

std::optional<int> Words::read(int count, char** words) {
    try {
        parser_->app.parse(count, words);
    } catch (const CLI::ParseError& error) {
        return parser_->app.exit(error);
    }
    return {};
}

} // namespace isomotion::bench
