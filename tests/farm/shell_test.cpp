// What a real /bin/sh reads back is what was to be said.
#include "farm/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nasty_words.h"
#include "program.h"

namespace isomotion::farm {
namespace {

using Words = std::vector<std::string>;

// Each ended by a NUL, which no word can hold.
std::string as_read_by_sh(const Words& words) {
    Words command{"/usr/bin/printf", "%s\\0"};
    command.insert(command.end(), words.begin(), words.end());
    const std::string line = command_line(command);
    EXPECT_EQ(line.find('\n'), line.npos);
    const cli::Ending ending = cli::run({"/bin/sh", "-c", line}, {});
    EXPECT_EQ(ending.code, 0) << ending << line;
    EXPECT_THAT(ending.err, testing::IsEmpty());
    return ending.out;
}

std::string ended_by_nul(const Words& words) {
    std::string text;
    for (const std::string& word : words) text += word + '\0';
    return text;
}

TEST(Shell, ReadsBackTheNastiestWords) {
    EXPECT_EQ(as_read_by_sh(nasty_words), ended_by_nul(nasty_words));
    EXPECT_EQ(as_read_by_sh({""}), ended_by_nul({""}));
}

TEST(Shell, ReadsBackAnyWords) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int k = 0; k < 40; ++k) {
        Words words;
        for (int n = 0; n < 30; ++n) words.push_back(nasty_word(random));
        EXPECT_EQ(as_read_by_sh(words), ended_by_nul(words));
    }
}

TEST(Shell, LeavesPlainWordsAsTheyAre) {
    EXPECT_EQ(command_line(Words{"isomotion", "render", "--frames=1-20x2,7", "/out/a.%04d.png"}),
              "isomotion render --frames=1-20x2,7 /out/a.%04d.png");
}

} // namespace
} // namespace isomotion::farm
