// The file that a scene becomes.
#include "page/page.h"

#include <cstdlib>
#include <regex>

#include <gmock/gmock.h>

#include "page/gallery.h"
#include "scene/reading/load.h"

namespace isomotion::page {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page_of(const std::string& scene) {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    return page(scene::load(scene));
}

TEST(Page, OfTheBlobbyIsSmall) {
    const std::string text = page_of("blobby75");
    EXPECT_LT(text.size(), 300'000u);
    EXPECT_THAT(text, HasSubstr("<title>75-sphere blobby</title>"));
}

TEST(Page, AsksNoOtherMachine) {
    const std::string text = page_of("blobby75_chrome");
    const std::regex loads(R"((src|href)="(?!data:|#))", std::regex::icase);
    EXPECT_FALSE(std::regex_search(text, loads));
    for (const char* word : {"http:", "https:", "import(", "@import", "url(", "fetch("})
        EXPECT_THAT(text, Not(HasSubstr(word))) << word;
}

TEST(Page, NeverSaysProved) { EXPECT_THAT(page_of("torus"), Not(HasSubstr("proved"))); }

TEST(Page, OfAFormulaHasItWhole) {
    EXPECT_THAT(page_of("x^2 + y^2 + z^2 = 1.25"), HasSubstr("x^2 + y^2 + z^2 = 1.25"));
}

TEST(Gallery, NamesItsPagesAndWhatHasNone) {
    const std::string text = gallery_index({{"torus", "A <torus>"}}, {"drops: 5000 & more"});
    EXPECT_THAT(text, HasSubstr("href=\"./torus.html\""));
    EXPECT_THAT(text, HasSubstr("A &lt;torus&gt;"));
    EXPECT_THAT(text, HasSubstr("<li>drops: 5000 &amp; more</li>"));
    EXPECT_THAT(gallery_index({}, {}), Not(HasSubstr("Without a page")));
}

} // namespace
} // namespace isomotion::page
