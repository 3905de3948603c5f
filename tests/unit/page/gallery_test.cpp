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

} // namespace
} // namespace isomotion::page
