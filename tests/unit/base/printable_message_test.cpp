#include "base/printable_message.h"

#include <gtest/gtest.h>

#include "base/printable.h"

namespace isomotion::base {
namespace {

TEST(PrintableMessage, ShortTextsStay) {
    EXPECT_EQ(shortened("key"), "key");
    EXPECT_EQ(shortened(std::string(200, 'k')), std::string(200, 'k'));
    EXPECT_EQ(printable_message("a.toml:1: key: 'one' is not 'two'\nb\r\n"),
              "a.toml:1: key: 'one' is not 'two'\nb\n");
}

TEST(PrintableMessage, LongTextsKeepBothEnds) {
    const std::string text = shortened("begin" + std::string(5'000'000, 'k') + "end");
    EXPECT_EQ(text.size(), 200u);
    EXPECT_TRUE(text.starts_with("begink"));
    EXPECT_TRUE(text.ends_with("kend"));
    EXPECT_NE(text.find("k...k"), text.npos);
}

TEST(PrintableMessage, NoCharacterIsCut) {
    std::string text;
    for (int k = 0; k < 300; ++k) text += "\u20ac"; // of three bytes
    for (std::size_t most = 50; most < 60; ++most) {
        const std::string cut = shortened(text, most);
        EXPECT_LE(cut.size(), most);
        EXPECT_TRUE(is_one_printable_line(cut)) << cut;
    }
}

TEST(PrintableMessage, MessagesTellWhatIsWrongWhateverTheyQuote) {
    for (const std::string& filling : {std::string(5'000'000, 'k'), [] {
                                           std::string words;
                                           for (int k = 0; k < 1'000'000; ++k) words += "it's ";
                                           return words;
                                       }()}) {
        const std::string message =
            printable_message("a.toml:1: method: there is no '" + filling + "'; known: b, c");
        EXPECT_TRUE(message.starts_with("a.toml:1: method: there is no '")) << message;
        EXPECT_TRUE(message.ends_with("'; known: b, c")) << message;
        EXPECT_LT(message.size(), 300u);
    }
    // Without quotes, as where a column or a folder is named.
    const std::string run(5'000'000, 'n');
    const std::string known =
        printable_message("a.csv: column x is missing; known: " + run + ", b");
    EXPECT_TRUE(known.ends_with("n, b")) << known;
    EXPECT_LT(known.size(), 300u);
    const std::string folder(150, 'f');
    const std::string path = "/" + folder + "/" + folder + "/" + folder + "/a.toml: is missing";
    EXPECT_EQ(printable_message(path), path) << "no part of it is long";
    // Quotes that nothing ends, in which no end may be looked for again and again.
    std::string open;
    for (int k = 0; k < 1'000'000; ++k) open += " 'k";
    EXPECT_LE(printable_message(open).size(), 1200u);
}

} // namespace
} // namespace isomotion::base
