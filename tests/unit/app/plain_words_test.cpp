// What new users type, and what they are told.
#include <CLI/CLI.hpp>
#include <gmock/gmock.h>

#include "app/commands.h"
#include "app/examples.h"
#include "app/plain_words.h"

namespace isomotion::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class PlainWords : public testing::Test {
protected:
    PlainWords() { add_commands(app_, chosen_); }
    CommandTree tree() const { return command_tree(app_); }
    CommandText command(const std::string& name) const {
        for (const CommandText& command : tree().commands) {
            if (command.name == name) return command;
        }
        throw std::invalid_argument(name);
    }

private:
    CLI::App app_{"", "isomotion"};
    Action chosen_;
};

TEST_F(PlainWords, HelpIsAskedForInAnyWay) {
    EXPECT_THAT(understood({"help"}, tree()), ElementsAre("--help"));
    EXPECT_THAT(understood({"help", "render"}, tree()), ElementsAre("render", "--help"));
    EXPECT_THAT(understood({"render", "help"}, tree()), ElementsAre("render", "--help"));
    EXPECT_THAT(understood({"render", "help", "-o", "a.png"}, tree()),
                ElementsAre("render", "help", "-o", "a.png"));
    EXPECT_THAT(understood({}, tree()), testing::IsEmpty());
}

TEST_F(PlainWords, AFormulaMayBeginWithAMinus) {
    EXPECT_THAT(understood({"render", "-x^2 + y = 1", "-o", "a.png"}, tree()),
                ElementsAre("render", "-o", "a.png", "--", "-x^2 + y = 1"));
    EXPECT_THAT(understood({"show", "-log(x)"}, tree()), ElementsAre("show", "--", "-log(x)"));
    const std::vector<std::string> as_they_are[] = {
        {"render", "-o", "a(1).png", "x"},  {"render", "-oa(1).png", "x"}, {"show", "--", "-x^2"},
        {"show", "x", "--set", "a=-1"},     {"show", "--stage=x", "y"},    {"-x^2"},
        {"render", "x", "--step", "-1e+1"},
    };
    for (const std::vector<std::string>& words : as_they_are)
        EXPECT_EQ(understood(words, tree()), words);
}

TEST_F(PlainWords, ASceneWithoutACommandIsToldTwo) {
    for (const char* scene : {"ring.toml", "a.jsurf", "x^2 + y^2 = 1", "blobby75"}) {
        const std::string why = why_no_command({scene}, tree());
        EXPECT_THAT(why, HasSubstr(" is a scene; name a command before it:"));
        EXPECT_THAT(why, HasSubstr("isomotion play "));
        EXPECT_THAT(why, HasSubstr("isomotion render "));
    }
    EXPECT_THAT(why_no_command({"x^2 = 1"}, tree()), HasSubstr("isomotion play 'x^2 = 1' "));
}

TEST_F(PlainWords, AWrongCommandIsToldTheNearest) {
    EXPECT_THAT(why_no_command({"rendr", "x"}, tree()), HasSubstr("did you mean 'render'?"));
    EXPECT_THAT(why_no_command({"animate"}, tree()), HasSubstr("known: render, submit, play"));
    EXPECT_EQ(why_no_command({"render"}, tree()), "");
    EXPECT_EQ(why_no_command({"--version"}, tree()), "");
}

TEST_F(PlainWords, AWrongOptionIsToldTheNearest) {
    EXPECT_EQ(why_left_over({"--siez"}, command("render")),
              "--siez: isomotion render has no such option; did you mean '--size'?\n");
    EXPECT_EQ(why_left_over({"--outputt=a.png"}, command("render")),
              "--outputt: isomotion render has no such option; did you mean '--output'?\n");
    EXPECT_EQ(why_left_over({"--nonsense"}, command("show")),
              "--nonsense: isomotion show has no such option; isomotion show --help lists those it "
              "has\n");
}

TEST_F(PlainWords, AFormulaWithoutQuotesIsToldOf) {
    EXPECT_THAT(why_left_over({"+", "y^2"}, command("play")),
                StartsWith("'+': write a formula in quotes"));
    EXPECT_THAT(why_left_over({"-x^2"}, command("render")),
                HasSubstr("isomotion render -- '-x^2 - y^2 + z^2 = 1'"));
    EXPECT_THAT(why_left_over({"ring.toml"}, command("list")),
                StartsWith("'ring.toml' is one word too many for isomotion list"));
}

TEST_F(PlainWords, EveryCommandHasAnExampleThatIsOne) {
    for (const CommandText& command : tree().commands) {
        const Example* example = example_of(command.name);
        ASSERT_TRUE(example) << command.name;
        EXPECT_THAT(std::string(example->line), StartsWith("isomotion " + command.name));
    }
    EXPECT_EQ(std::size(examples), tree().commands.size());
}

TEST(FirstWords, SayWhatItIsInTenLinesWithThreeExamples) {
    const std::string words = first_words();
    EXPECT_LE(std::ranges::count(words, '\n'), 10);
    int examples_told = 0;
    for (std::size_t at = words.find("\n  isomotion "); at != words.npos;
         at = words.find("\n  isomotion ", at + 1))
        ++examples_told;
    EXPECT_EQ(examples_told, 3);
}

} // namespace
} // namespace isomotion::app
