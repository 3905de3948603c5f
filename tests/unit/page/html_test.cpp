// What a title or a formula holds ends no element of a page.
#include "page/html.h"

#include <gmock/gmock.h>

namespace isomotion::page {
namespace {

TEST(Html, TextEndsNoElementAndNoQuotes) {
    EXPECT_EQ(html_text("</script><b a=\"1\" c='2'> & &amp;"),
              "&lt;/script&gt;&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt; &amp; &amp;amp;");
    EXPECT_EQ(html_text("x² + y² ≤ 1"), "x² + y² ≤ 1");
}

TEST(Html, PartsAreTakenAsTheyAre) {
    EXPECT_EQ(filled("<a>{{one}}</a>{{two}}{{one}}", {{"one", "{{two}}"}, {"two", "2"}}),
              "<a>{{two}}</a>2{{two}}");
    EXPECT_EQ(filled("nothing", {}), "nothing");
    EXPECT_THROW(filled("{{three}}", {{"one", ""}}), std::logic_error);
}

} // namespace
} // namespace isomotion::page
