#include "shader/active_lines.h"

#include <stdexcept>

#include <gmock/gmock.h>

#include "base/input_error.h"
#include "scenes.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"

namespace isomotion::shader {
namespace {

// With two flags and a number.
std::string active(const std::string& text) {
    Features features;
    features.add(Feature::lists);
    features.add(Feature::grid);
    features.add(Feature::lights, "3");
    return active_lines("a.glsl", text, features);
}

// The condition's answer, in a file.
bool holds(const std::string& condition) {
    return active(condition + "\nyes\n#endif\n") == "yes\n";
}

std::string complaint(const std::string& text) {
    try {
        active(text);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(ActiveLines, KeepWhatAsksForNothing) {
    for (const char* text : {"", "float f;\n", "#define A 1\n#undef A\n#extension x : enable\n\n"})
        EXPECT_EQ(active(text), text);
    EXPECT_EQ(active("no end"), "no end\n");
}

TEST(ActiveLines, FollowFeatures) {
    EXPECT_TRUE(holds("#ifdef LISTS"));
    EXPECT_FALSE(holds("#ifndef LISTS"));
    EXPECT_FALSE(holds("#ifdef COPIES // with a comment"));
    EXPECT_TRUE(holds("#ifndef COPIES"));
    EXPECT_TRUE(holds("  #  if LISTS // LIGHTS == 0"));
    EXPECT_FALSE(holds("#if !LISTS"));
    EXPECT_TRUE(holds("#if defined(LIGHTS) && !defined(COPIES)"));
    EXPECT_TRUE(holds("#if COPIES || LISTS && GRID"));
    EXPECT_FALSE(holds("#if (COPIES || LISTS) && !GRID"));
    EXPECT_TRUE(holds("#if LISTS || COPIES"));
}

TEST(ActiveLines, CompareNumbers) {
    for (const char* condition : {"LIGHTS == 3", "LIGHTS != 2", "LIGHTS > 2", "LIGHTS < 4",
                                  "LIGHTS >= 3", "LIGHTS <= 3", "LIGHTS", "SECTIONS == 0"})
        EXPECT_TRUE(holds(std::string("#if ") + condition)) << condition;
    for (const char* condition :
         {"LIGHTS == 2", "LIGHTS != 3", "LIGHTS > 3", "LIGHTS < 3", "SECTIONS", "SECTIONS > 0"})
        EXPECT_FALSE(holds(std::string("#if ") + condition)) << condition;
}

TEST(ActiveLines, TakeTheFirstThatHolds) {
    const auto chosen = [](const std::string& first, const std::string& second) {
        return active("#if " + first + "\na\n#elif " + second + "\nb\n#else\nc\n#endif\nd\n");
    };
    EXPECT_EQ(chosen("LISTS", "GRID"), "a\nd\n");
    EXPECT_EQ(chosen("COPIES", "GRID"), "b\nd\n");
    EXPECT_EQ(chosen("COPIES", "!GRID"), "c\nd\n");
}

TEST(ActiveLines, Nest) {
    const std::string text = "#ifdef %\na\n#ifdef GRID\nb\n#else\nc\n#endif\nd\n#else\n"
                             "#ifndef GRID\ne\n#elif LIGHTS == 3\nf\n#endif\ng\n#endif\n";
    const auto with = [&](const std::string& name) {
        std::string copy = text;
        return active(copy.replace(copy.find('%'), 1, name));
    };
    EXPECT_EQ(with("LISTS"), "a\nb\nd\n");
    EXPECT_EQ(with("COPIES"), "f\ng\n");
}

TEST(ActiveLines, LeaveCompilersWhatIsTheirs) {
    const std::string theirs = "#ifdef GL_ES\na\n#elif __VERSION__ < 400\nb\n#ifndef GL_x\nc\n"
                               "#endif\n#else\nd\n#endif\n";
    EXPECT_EQ(active(theirs), theirs);
    EXPECT_EQ(active("#ifdef LISTS\n" + theirs + "#endif\n"), theirs);
    EXPECT_EQ(active("#ifdef COPIES\n" + theirs + "#else\nno\n#endif\n"), "no\n");
    EXPECT_EQ(active("#ifdef GL_ES\n#ifdef LISTS\na\n#else\nb\n#endif\n#else\nc\n#endif\n"),
              "#ifdef GL_ES\na\n#else\nc\n#endif\n");
}

TEST(ActiveLines, TellWhereAFileIsWrong) {
    using testing::HasSubstr, testing::StartsWith;
    EXPECT_THAT(complaint("\n#ifdef LIST\n#endif\n"),
                StartsWith("shaders/a.glsl:2: 'LIST' is no feature, nearest LISTS"));
    // Also where it does not matter, and where a name stands for nothing.
    EXPECT_THAT(complaint("#ifdef COPIES\n\n#if LISTS && Q\n#endif\n#endif\n"),
                StartsWith("shaders/a.glsl:3: 'Q' is no feature"));
    EXPECT_THAT(complaint("#ifdef LISTS\n#elif Q\n#endif\n"), HasSubstr(":2: 'Q' is no feature"));
    EXPECT_THAT(complaint("#if LISTS || Q\n#endif\n"), HasSubstr("'Q' is no feature"));
    EXPECT_THAT(complaint("#ifdef LISTS\na\n"), HasSubstr("a.glsl:2: #endif is missing"));
    EXPECT_THAT(complaint("a\n#endif\n"), HasSubstr("a.glsl:2: #endif without #if"));
    EXPECT_THAT(complaint("#else\n"), HasSubstr("#else without #if"));
    EXPECT_THAT(complaint("#elif LISTS\n"), HasSubstr("#elif without #if"));
    EXPECT_THAT(complaint("#ifdef LISTS\n#else\n#else\n#endif\n"), HasSubstr("#else after #else"));
    EXPECT_THAT(complaint("#ifdef LISTS\n#else\n#elif GRID\n#endif\n"),
                HasSubstr(":3: #elif after #else"));
    EXPECT_THAT(complaint("#if LISTS GRID\n#endif\n"), HasSubstr("unexpected 'GRID'"));
    EXPECT_THAT(complaint("#if (LISTS\n#endif\n"), HasSubstr("')' is missing"));
    EXPECT_THAT(complaint("#if LIGHTS == x\n#endif\n"), HasSubstr("'x' is no whole number"));
    EXPECT_THAT(complaint("#if\n#endif\n"), HasSubstr("'' is no feature"));
}

TEST(ActiveLines, EveryShaderFileAsksForFeatures) {
    use_shaders_of_source_tree();
    for (const std::string& file : shader_files()) {
        Features none;
        EXPECT_NO_THROW(active_lines(file, read_shader(file), none)) << file;
    }
}

TEST(Features, AreInTheOrderOfTheirTable) {
    std::set<std::string_view> macros;
    for (int k = 0; k <= int(Feature::fused); ++k) {
        const FeatureTraits& row = traits(Feature(k));
        EXPECT_EQ(row.feature, Feature(k)) << row.macro;
        EXPECT_EQ(feature_of(row.macro), Feature(k));
        macros.insert(row.macro);
    }
    EXPECT_EQ(macros.size(), std::size_t(Feature::fused) + 1);
    EXPECT_FALSE(feature_of("NONE"));
}

TEST(Features, HaveOneValueBeforeTheyAreAskedFor) {
    Features features;
    EXPECT_TRUE(features.add(Feature::lights, "2"));
    EXPECT_FALSE(features.add(Feature::lights, "2"));
    EXPECT_THROW(features.add(Feature::lights, "3"), std::logic_error);
    EXPECT_EQ(features.value(Feature::lights), 2);
    EXPECT_FALSE(features.has(Feature::lists));
    EXPECT_THROW(features.add(Feature::lists), std::logic_error);
    EXPECT_EQ(features.value(Feature::sections), 0);
    EXPECT_THROW(features.add(Feature::sections, "1"), std::logic_error);
}

TEST(ShaderText, HasTheValuesOfFeaturesAndNoFlags) {
    use_shaders_of_source_tree();
    ShaderText text;
    text.define(Feature::lists);
    text.define(Feature::lights, 2);
    text.define(Feature::lights, 2);
    EXPECT_EQ(occurrences(text.text(), "#define LIGHTS 2\n"), 1);
    EXPECT_EQ(occurrences(text.text(), "LISTS"), 0);
}

// A file once more, with other names.
TEST(ShaderText, ReplacesWholeWords) {
    use_shaders_of_source_tree();
    ShaderText text;
    text.instance("tape/run.glsl", {{"TAPE_RUN", "run"}, {"TAPE_STEP", "step"}});
    text.instance("tape/run.glsl", {{"TAPE_RUN", "again"}}, {Feature::calls});
    EXPECT_EQ(occurrences(text.text(), "void run(uvec2 span)"), 1);
    EXPECT_EQ(occurrences(text.text(), "void again(uvec2 span)"), 1);
    EXPECT_EQ(occurrences(text.text(), "step(at + 7"), 1);
    EXPECT_EQ(occurrences(text.text(), "TAPE_CALL(word"), 1) << "where there are calls";
}

} // namespace
} // namespace isomotion::shader
