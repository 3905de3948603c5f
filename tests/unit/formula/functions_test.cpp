// The table of functions, and what the parser, the names and the documents make of it.
#include "formula/graph/functions.h"

#include <cctype>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "testing.h"

namespace isomotion::formula {
namespace {

std::string call(const Function& function, std::size_t count, std::string_view argument) {
    std::string text = fmt::format("{}(", function.name);
    for (std::size_t k = 0; k < count; ++k)
        text += fmt::format("{}{}", k > 0 ? ", " : "", argument);
    return text + ")";
}

TEST(Functions, HaveDifferentNamesThatAreReserved) {
    std::set<std::string_view> names;
    for (const Function& function : functions()) {
        EXPECT_TRUE(names.insert(function.name).second) << function.name;
        EXPECT_TRUE(is_reserved(function.name)) << function.name;
        EXPECT_EQ(find_function(function.name), &function);
    }
    EXPECT_EQ(find_function("si"), nullptr);
    EXPECT_EQ(find_function(""), nullptr);
}

TEST(Functions, TakeAsManyArgumentsAsTheyHave) {
    Vocabulary vocabulary = test_vocabulary();
    vocabulary.allows_random = true;
    for (const Function& function : functions()) {
        if (!function.call && function.name != "pow") continue; // arrays and degrees are no values
        const auto parses = [&](std::size_t count) {
            Graph graph;
            try {
                parse(call(function, count, "x"), vocabulary, graph);
                return std::string();
            } catch (const ParseError& error) {
                return error.message();
            }
        };
        EXPECT_EQ(parses(function.count), "");
        if (function.may_have_more) {
            EXPECT_EQ(parses(function.count + 1), "");
            EXPECT_EQ(parses(function.count + 7), "");
            EXPECT_EQ(parses(function.count - 1),
                      fmt::format("{} takes two or more", function.name));
            continue;
        }
        for (const std::size_t count : {std::size_t(0), function.count - 1, function.count + 1}) {
            EXPECT_EQ(parses(count),
                      fmt::format("{} takes {} argument{}, not {}", function.name, function.count,
                                  function.count == 1 ? "" : "s", count));
        }
    }
}

TEST(Functions, AreDefinedForConstantsWhereTheyHaveAValue) {
    for (const Function& function : functions()) {
        if (!function.has_value) continue;
        for (const double x : {-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0}) {
            const std::string text = fmt::format("{}({})", function.name, x);
            Graph graph;
            if (function.has_value(x)) {
                EXPECT_NO_THROW(parse(graph, text)) << text;
            } else {
                EXPECT_THROW(parse(graph, text), ParseError) << text;
            }
        }
    }
}

std::string read(const std::string& name) {
    std::ifstream file(ISOMOTION_SOURCE_DIR "/docs/" + name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

bool is_part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

bool has_word(const std::string& text, std::string_view word) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const bool begins = at == 0 || !is_part_of_name(text[at - 1]);
        if (begins && !is_part_of_name(text[at + word.size()])) return true;
    }
    return false;
}

// The list at the top of docs/formulas.md, and random's place in docs/scene-file.md.
TEST(Functions, AreThoseOfTheDocuments) {
    const std::string page = read("formulas.md"), scenes = read("scene-file.md");
    const auto begin = page.find("    + - * / ^"), end = page.find("\n\n`^` binds");
    ASSERT_NE(begin, std::string::npos);
    ASSERT_NE(end, std::string::npos);
    const std::string list = page.substr(begin, end - begin);
    for (const Function& function : functions()) {
        const std::string written = fmt::format("{}({})", function.name, function.arguments);
        if (function.name == "random") {
            EXPECT_NE(scenes.find(written), std::string::npos);
        } else if (function.has_value) {
            EXPECT_TRUE(has_word(list, function.name)) << function.name;
        } else {
            EXPECT_NE(list.find(written), std::string::npos) << written;
        }
    }
    // And nothing that is no function: names of the first line, and those that are called.
    std::istringstream lines(list);
    std::string line, word;
    std::getline(lines, line);
    for (std::istringstream words(line); words >> word;) {
        if (!is_part_of_name(word[0])) continue; // + - *
        EXPECT_NE(find_function(word), nullptr) << word;
    }
    while (std::getline(lines, line)) {
        const auto first = line.find_first_not_of(' ');
        if (first == std::string::npos) continue;
        const std::string name = line.substr(first, line.find('(') - first);
        EXPECT_NE(find_function(name), nullptr) << line;
    }
}

} // namespace
} // namespace isomotion::formula
