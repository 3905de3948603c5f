// What a scene may hold at most: that much is read, one more is a mistake that is told.
#include "scene/limits.h"

#include "testing.h"

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string repeat(std::string_view part, std::size_t times) {
    std::string text;
    for (std::size_t k = 0; k < times; ++k) text += part;
    return text;
}

class Limits : public Scenes {
protected:
    void expect_fine(const std::string& text) { EXPECT_EQ(mistake(text), "nothing is wrong"); }
};

TEST_F(Limits, Titles) {
    const std::string longest(limits::title_bytes, 'a');
    expect_fine(ball_with(1, "title = \"" + longest + "\""));
    EXPECT_EQ(mistake(ball_with(1, "title = \"" + longest + "a\"")),
              "scene.toml:1: title: must be one line of at most 1000 bytes, without control "
              "characters");
}

TEST_F(Limits, Names) {
    const std::string longest(limits::name_bytes, 'a');
    const auto with_name = [](const std::string& name) {
        return ball_with(6, "formula = \"x^2 + y^2 + z^2 - radius - " + name + "\"") + "";
    };
    expect_fine(with_name(longest) + "[parameters." + longest + "]\ndefault = 1\n");
    EXPECT_THAT(mistake(with_name("radius") + "[parameters." + longest + "a]\ndefault = 1\n"),
                HasSubstr(": a name of 65 characters; at most 64 are read"));
    EXPECT_THAT(mistake(ball_with(6, "formula = \"" + longest + "a = x; x\"")),
                HasSubstr("a name of 65 characters; at most 64 are read"));
}

TEST_F(Limits, Parameters) {
    const auto with = [](int count) {
        std::string formula = "x", parameters;
        for (int k = 1; k < count; ++k) {
            formula += fmt::format(" + p{}", k);
            parameters += fmt::format("p{} = {}\n", k, k);
        }
        return "[surface]\nformula = \"" + formula +
               " + r\"\nbounds = { sphere = 1 }\n[parameters]\n" + parameters + "r = 1\n";
    };
    expect_fine(with(limits::parameters));
    EXPECT_THAT(mistake(with(limits::parameters + 1)),
                HasSubstr("is one too many: a scene has at most 1000 parameters"));
    // A field that is the same for all elements is one, too.
    EXPECT_THAT(mistake(with(limits::parameters) + "[arrays.a]\ncount = 2\nw = 3\n"),
                HasSubstr("arrays.a.w: is one too many: parameters, and fields with one value for "
                          "all elements, are at most 1000 together"));
}

TEST_F(Limits, Keys) {
    const auto with = [](int count) {
        std::string keys;
        for (int k = 0; k < count; ++k) keys += fmt::format("[{},1],", k);
        return ball_with(9, "radius = { keys = [" + keys + "] }");
    };
    expect_fine(with(limits::keys));
    EXPECT_EQ(mistake(with(limits::keys + 1)),
              "scene.toml:9: parameters.radius: has 100001 keys; at most 100000 are possible");
}

TEST_F(Limits, FieldsAndColumns) {
    const auto with = [](int count) {
        std::string fields, formula;
        for (int k = 0; k < count; ++k) {
            fields += fmt::format("f{} = \"i\"\n", k);
            formula += fmt::format("+f{}", k);
        }
        return "[surface]\nformula = \"x - sum(blobs, 0" + formula +
               ")\"\nbounds = { sphere = 3 }\n[arrays.blobs]\ncount = 2\n" + fields;
    };
    expect_fine(with(limits::fields));
    EXPECT_THAT(mistake(with(limits::fields + 1)),
                HasSubstr("arrays.blobs: has 1001 fields; at most 1000 are possible"));

    const auto table = [&](int columns) {
        std::string names = "cx", values = "0";
        for (int k = 1; k < columns; ++k) {
            names += fmt::format(",c{}", k);
            values += ",1";
        }
        write("drops.csv", names + "\n" + values + "\n");
        return mistake("[surface]\nformula = \"sum(drops, x-cx)\"\nbounds = { sphere = 3 }\n"
                       "[arrays.drops]\nfile = \"drops.csv\"\n");
    };
    EXPECT_EQ(table(limits::fields), "nothing is wrong");
    EXPECT_EQ(table(limits::fields + 1), "drops.csv:1: names 1001 columns; at most 1000 are read");
    write("drops.csv", "cx,cy\n" + std::string(50'000'000, ',') + "\n");
    EXPECT_EQ(mistake("[surface]\nformula = \"sum(drops, x-cx)\"\nbounds = { sphere = 3 }\n"
                      "[arrays.drops]\nfile = \"drops.csv\"\n"),
              "drops.csv:2: has 50000001 cells; the header names 2 columns");
}

TEST_F(Limits, WorkAtAPoint) {
    const auto with = [](int a, int b) {
        return fmt::format("[surface]\nformula = \"sum(a, sum(b, abs(x-p*q)))\"\n"
                           "bounds = {{ sphere = 1 }}\n[arrays.a]\ncount = {}\np = \"i\"\n"
                           "[arrays.b]\ncount = {}\nq = \"i\"\n",
                           a, b);
    };
    expect_fine(with(20, 20));
    EXPECT_THAT(mistake(with(limits::elements, limits::elements)),
                HasSubstr("operations at one point, all elements of its sums counted; at most "
                          "1e+08 are possible: give its arrays fewer elements"));
}

std::string arrays(int many, int fields, const std::string& read) {
    std::string text = "[surface]\nformula = \"x" + read + "\"\nbounds = { sphere = 1 }\n";
    for (int a = 0; a < many; ++a) {
        text += fmt::format("[arrays.a{}]\ncount = 1000000\n", a);
        for (int f = 0; f < fields; ++f) text += fmt::format("f{} = \"i+{}\"\n", f, f);
    }
    return text;
}

// Each array is within what one may have.
TEST_F(Limits, ValuesOfAllArraysTogether) {
    std::string read;
    for (int a = 0; a < 12; ++a) read += fmt::format(" + sum(a{}, f0*x)/1e6", a);
    EXPECT_THAT(
        mistake(arrays(12, 1, read)),
        HasSubstr("the fields of all arrays hold 1.2e+07 values at each frame, all elements "
                  "counted, those of 'a0' 1e+06; at most 1e+07 are possible"));
}

TEST_F(Limits, ArraysThatNothingReadsCostNothing) {
    const Scene scene = loaded(arrays(32, 300, ""));
    for (const auto& array : scene.surfaces[0].animation.at(scene.timeline.time(1)).arrays) {
        EXPECT_EQ(array.count, 1'000'000);
        for (const auto& field : array.fields) EXPECT_TRUE(field.empty());
    }
}

TEST_F(Limits, NumbersOfAllTablesTogether) {
    std::string table = "c0,c1,c2,c3,c4,c5,c6,c7,c8,c9\n";
    table += repeat("1,2,3,4,5,6,7,8,9,0\n", 1'000'000);
    for (const char* name : {"0", "1", "2", "3"}) write(std::string(name) + ".csv", table);
    const auto with = [](auto file) {
        std::string text = "[surface]\nformula = \"x\"\nbounds = { sphere = 1 }\n";
        for (int a = 0; a < 4; ++a)
            text += fmt::format("[arrays.a{}]\nfile = \"{}.csv\"\n", a, file(a));
        return text;
    };
    expect_fine(with([](int) { return 0; })); // one that is named alike is read once
    EXPECT_EQ(
        mistake(with([](int a) { return a; })),
        "3.csv:1: has 1000000 lines, and 1e+07 numbers of them are kept; all tables of a scene "
        "hold at most 3e+07: leave columns out that the formula doesn't read");
}

TEST_F(Limits, BytesOfAllTablesTogether) {
    const std::string table =
        "x,y\n1,2\n#" + std::string(limits::table_bytes / 2 + 100, ' ') + "\n";
    for (const char* name : {"0.csv", "1.csv"}) write(name, table);
    const auto with = [](auto file) {
        std::string text = "[surface]\nformula = \"x\"\nbounds = { sphere = 1 }\n";
        for (int a = 0; a < 4; ++a) {
            text += fmt::format("[arrays.a{}]\nfile = \"{}.csv\"\ncolumns = {{ c{} = \"x\" }}\n", a,
                                file(a), a);
        }
        return text;
    };
    expect_fine(with([](int) { return 0; })); // one that is named in several ways is read once
    EXPECT_THAT(
        mistake(with([](int a) { return a / 2; })),
        HasSubstr(fmt::format("1.csv: has {} bytes; {} are left of the 268435456 of all tables "
                              "that arrays of a scene name",
                              table.size(), limits::table_bytes - table.size())));
}

TEST_F(Limits, WorkOfAFrame) {
    const auto with = [](int terms) {
        std::string sum = "i";
        for (int k = 1; k <= terms; ++k) sum += fmt::format("+sin({}*i)", k);
        return blobs("count = 1000000\nw = 1\ncx = \"" + sum + "\"");
    };
    EXPECT_THAT(mistake(with(400)), HasSubstr("arrays.blobs.cx: the fields of 'blobs' take"));
}

TEST_F(Limits, FilesOfScenes) {
    const std::string scene = ball();
    std::string padded = scene + "#" + std::string(limits::scene_bytes - scene.size() - 1, ' ');
    expect_fine(padded);
    EXPECT_EQ(mistake(padded + " "),
              "scene.toml: is larger than 16777216 bytes, the most that is read");
}

TEST_F(Limits, ChainsOfNames) {
    const auto with = [](std::size_t length, bool forwards) {
        std::string text;
        for (std::size_t k = 2; k < length; ++k) {
            const std::size_t next = forwards ? k + 1 : k - 1;
            const bool last = forwards ? k + 1 == length : k == 2;
            text += last ? fmt::format("p{:04} = \"t\"\n", k)
                         : fmt::format("p{:04} = \"p{:04}\"\n", k, next);
        }
        return ball_with(9, "radius = \"1 + " + fmt::format("p{:04}", forwards ? 2 : length - 1) +
                                "\"\n" + text);
    };
    for (const bool forwards : {true, false}) {
        expect_fine(with(formula::limits::chain + 1, forwards));
        EXPECT_THAT(mistake(with(formula::limits::chain + 2, forwards)),
                    HasSubstr("depends on others through a chain of more than 200; let it name "
                              "directly what it needs"));
    }
}

constexpr int nesting = 32; // as the message says

// Depth that ends in a stack, by every way that TOML has to make it.
TEST_F(Limits, NestingOfTables) {
    for (const std::size_t depth : {std::size_t(nesting) + 1, std::size_t(200'000)}) {
        for (const std::string& text :
             {"a = " + repeat("[", depth), "a = " + repeat("[", depth) + repeat("]", depth),
              "a = " + repeat("{ a = ", depth), "a" + repeat(".a", depth) + " = 1",
              "[a" + repeat(".a", depth) + "]", "[[a" + repeat(".a", depth) + "]]",
              "a" + repeat(" . 'a.b'", depth) + " = 1",
              "a" + repeat(".\"\\\"\"", depth) + " = 1"}) {
            EXPECT_EQ(mistake(ball_and(text)),
                      "scene.toml:15: tables and lists are nested too deeply; 32 deep are read")
                << text.substr(0, 40);
        }
    }
    EXPECT_THAT(mistake(ball_and("a = " + repeat("[", nesting) + repeat("]", nesting))),
                HasSubstr("unknown key"));
}

} // namespace
} // namespace isomotion::scene
