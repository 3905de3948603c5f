#include "base/document.h"

#include <cstdlib>

#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/input_error.h"

namespace isomotion::base {
namespace {

using testing::ElementsAre;

Document json(const std::string& text) { return Document::from_json(text, "a.json"); }
Document toml(const std::string& text) { return Document::from_toml(text, "a.toml"); }

// What the reading of a document says.
template<class Read> std::string mistake(const Document& document, Read&& read) {
    try {
        DocumentTable table = document.table();
        read(table);
        table.refuse_rest();
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

std::string refused_json(const std::string& text) {
    try {
        json(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(Document, GivesWhatIsWritten) {
    for (const Document& document :
         {json(R"({"b": 1.5, "a": {"d": [1, "x"], "c": true}, "n": 9007199254740993})"),
          toml("b = 1.5\nn = 9007199254740993\n[a]\nd = [1, 'x']\nc = true\n")}) {
        DocumentTable root = document.table();
        EXPECT_EQ(root.at("b").number(), 1.5);
        EXPECT_EQ(root.at("n").whole(), 9007199254740993);
        DocumentTable a = root.at("a").table();
        EXPECT_TRUE(a.at("c").boolean());
        const auto list = a.at("d").list(2);
        EXPECT_EQ(list[0].integer(1, 1), 1);
        EXPECT_EQ(list[1].text(), "x");
        EXPECT_FALSE(root.find("none"));
        EXPECT_NO_THROW(root.refuse_rest());
    }
}

TEST(Document, KeepsTheOrderOfJson) {
    const Document document = json(R"({"b": 1, "a": 2, "c": 3})");
    DocumentTable root = document.table();
    std::vector<std::string> keys;
    for (const DocumentNode& each : root.all()) keys.push_back(root.key_of(each));
    EXPECT_THAT(keys, ElementsAre("b", "a", "c"));
}

TEST(Document, SaysWhereAMistakeIs) {
    const Document from_toml = toml("[a]\nb = [1,\n2,\n'x']\n");
    const auto numbers = [](DocumentTable& root) {
        DocumentTable a = root.at("a").table();
        for (const DocumentNode& each : a.at("b").list()) each.number();
    };
    EXPECT_EQ(mistake(from_toml, numbers), "a.toml:4: a.b[2]: must be a number");
    EXPECT_EQ(mistake(json(R"({"a": {"b": [1, "x"]}})"), numbers),
              "a.json:1: a.b[1]: must be a number");
    EXPECT_EQ(mistake(json("{\"n\": 1,\n \"a\":\n{\"b\": [1\n, 2,\n\"x\"\n]}}"), numbers),
              "a.json:5: a.b[2]: must be a number");
    EXPECT_EQ(mistake(json("{\"a\": {\n\"b\": [\n1,\ntrue\n]}}"), numbers),
              "a.json:4: a.b[1]: must be a number");
    EXPECT_EQ(mistake(json("{\"a\": [[0], {\n\"b\":\n2}]}"),
                      [](DocumentTable& root) { root.at("a").list()[1].table().at("b").text(); }),
              "a.json:2: a[1].b: must be a text");
    EXPECT_EQ(mistake(json("{\"a\": [{\"b\": 1},\n{\n}]}"),
                      [](DocumentTable& root) { root.at("a").list()[1].table().at("b"); }),
              "a.json:2: a[1]: has no key 'b', which it needs");
    const auto small = [](DocumentTable& root) {
        for (const DocumentNode& each : root.at("a").list()) each.integer(0, 4);
    };
    EXPECT_EQ(mistake(json("{\"a\": [\n1,\n5\n]}"), small),
              "a.json:3: a[1]: must be a whole number from 0 to 4"); // a number ends a line
    const auto nothing = [](DocumentTable&) {};
    EXPECT_EQ(mistake(json("[]"), nothing), "a.json: must be an object, in { }");
    EXPECT_EQ(mistake(json("{}"), [](DocumentTable& root) { root.at("b"); }),
              "a.json: has no key 'b', which it needs");
    const auto radius = [](DocumentTable& root) { root.find("radius"); };
    EXPECT_EQ(mistake(json(R"({"radus": 1})"), radius),
              "a.json:1: radus: unknown key; did you mean 'radius'?");
    EXPECT_EQ(mistake(json(R"({"x": 1})"), radius), "a.json:1: x: unknown key; known here: radius");
}

TEST(Document, NumbersAreInTheirRange) {
    const auto read = [](const std::string& text, auto&& get) {
        return mistake(json("{\"a\": " + text + "}"),
                       [&](DocumentTable& root) { get(root.at("a")); });
    };
    const auto small = [](const DocumentNode& node) { node.integer(-2, 5); };
    EXPECT_EQ(read("-2", small), "none");
    for (const char* text : {"6", "-3", "1.5", "1e0", "99999999999", "18446744073709551615"}) {
        EXPECT_EQ(read(text, small), "a.json:1: a: must be a whole number from -2 to 5") << text;
    }
    const auto whole = [](const DocumentNode& node) { node.whole(); };
    EXPECT_EQ(read("-9223372036854775808", whole), "none");
    EXPECT_EQ(read("9223372036854775807", whole), "none");
    EXPECT_EQ(read("9223372036854775808", whole), "a.json:1: a: must be a whole number");
}

TEST(Document, MalformedTextIsRefused) {
    EXPECT_EQ(refused_json(R"({"a": 1, "b": {"a": 2}, "a": 3})"),
              "a.json:1: a: is given twice; keep one of them");
    EXPECT_THAT(refused_json("{"), testing::StartsWith("a.json: not valid JSON: parse error"));
    EXPECT_THROW(toml("a = 1\na = 2\n"), InputError);
    EXPECT_THROW(toml("a = " + std::string(100'000, '[')), InputError);
    EXPECT_THROW(toml("a = 2020-01-01"), InputError);
}

TEST(Document, DepthIsLimited) {
    EXPECT_EQ(refused_json(std::string(64, '[') + std::string(64, ']')), "none");
    for (const std::size_t depth : {std::size_t(65), std::size_t(4) << 20}) {
        EXPECT_THAT(refused_json("{\"a\":\n" + std::string(depth, '[')),
                    testing::AllOf(testing::StartsWith("a.json:2: a[0]"),
                                   testing::EndsWith("objects and lists are nested too deeply; 64 "
                                                     "deep are read")));
    }
}

// Processor seconds end a reading whose time grows with the square.
void read_large_documents() {
    const rlimit limit{10, 10};
    ::setrlimit(RLIMIT_CPU, &limit);
    constexpr int many = 300'000;
    std::string keys = "{\"a\": {\"k\": 1", items = "{\"a\": [1", lines = "[a]\nk = 1\n";
    for (int k = 0; k < many; ++k) {
        keys += ",\"" + std::to_string(k) + "\": {}";
        items += ",{}";
    }
    for (int k = 0; k < many / 3; ++k) lines += std::to_string(k) + " = {}\n";
    for (const Document& document : {json(keys + "}}"), toml(lines)}) {
        DocumentTable root = document.table();
        DocumentTable table = root.at("a").table();
        if (table.all().size() < std::size_t(many) / 3) std::exit(1);
        table.refuse_rest();
    }
    const Document document = json(items + "]}");
    DocumentTable root = document.table();
    std::exit(root.at("a").list(many + 1).empty());
}

TEST(Document, ManyKeysTakeNoMoreThanTheirNumber) {
    EXPECT_EXIT(read_large_documents(), testing::ExitedWithCode(0), "");
}

TEST(Document, NoNameBeginsALine) {
    try {
        Document::from_json("{\"\\nforged\": 1, \"\\nforged\": 2}", "a\nforged.json");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace isomotion::base
