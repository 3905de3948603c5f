#include "base/toml.h"

#include <gtest/gtest.h>

namespace isomotion::base {
namespace {

// Brackets and dots of texts and comments are none.
TEST(TomlDepth, IsThatOfTheTree) {
    for (const char* flat :
         {"a = '[[[['", "a = \"[[[\\\"[[[\"", "# [[[[", "a = \"\"\"\n[[[[\"\" [[[[\"\"\"\nb = 1",
          "a = '''\n[[[['' [[['''''\nb = 1",
          "a = \"\"\nb = \"\\\\\"\nc = [1.5, 2.5, 3.5, 4.5, 5.5]",
          "a = 1.5\nb = 1.5\nc = 1.5\nd = 1.5\n", "a = [1]\nb = [2]\n[c]\n[d]\n[[e]]\n[[e]]"}) {
        EXPECT_EQ(first_line_nested_beyond(flat, 3), 0) << flat;
    }
    for (const char* deep :
         {"\n\na = [[[[1]]]]", "\n''\na.b.c.d.e = 1", "\n\n[[a.b.c]]",
          "\n\"\"\"\"\"\"\"\"\n{a = [{b = [", "\n# '\n[[[[", "\n\"\\\"\"\n[[[["}) {
        EXPECT_EQ(first_line_nested_beyond(deep, 3), 3) << deep;
    }
}

} // namespace
} // namespace isomotion::base
