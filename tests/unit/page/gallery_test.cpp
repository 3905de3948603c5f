#include "page/gallery.h"

#include <gtest/gtest.h>

namespace isomotion::page {
namespace {

TEST(Gallery, TellsNotWhereFilesLie) {
    const auto told = [](const std::string& message) {
        return without_place_in_file(message, "cups.toml");
    };
    EXPECT_EQ(told("/home/me/cups.toml:44: surfaces.glass: one alone"),
              "surfaces.glass: one alone");
    EXPECT_EQ(told("/home/me/cups.toml: no surface"), "no surface");
    EXPECT_EQ(told("cups.toml:7: 3 lights: too many"), "3 lights: too many");
    EXPECT_EQ(told("cups.toml: 3 lights: too many"), "3 lights: too many");
    EXPECT_EQ(told("cups.toml:"), "");
    EXPECT_EQ(told("cups.toml:12"), "12");
    EXPECT_EQ(told("shaders are too long"), "shaders are too long");
}

// Names of files are strangers' text, too.
TEST(Gallery, LinksToFilesWhateverTheirNames) {
    const std::string index = gallery_index(
        {{"javascript:alert(1)//", "One"}, {"a?b#c%20d\"<é", "Two"}, {"plain-1", "Three"}}, {});
    const auto holds = [&](const char* text) { return index.find(text) != index.npos; };
    EXPECT_TRUE(holds("href=\"./javascript%3Aalert%281%29%2F%2F.html\"")) << index;
    EXPECT_TRUE(holds("src=\"./a%3Fb%23c%2520d%22%3C%C3%A9.png\"")) << index;
    EXPECT_TRUE(holds("href=\"./plain-1.html\"")) << index;
    EXPECT_FALSE(holds("\"javascript:"));
}

} // namespace
} // namespace isomotion::page
