#include "formula/graph/vocabulary.h"

#include <gtest/gtest.h>

namespace isomotion::formula {
namespace {

TEST(Identifier, Form) {
    for (const auto* name : {"a", "_", "a1", "_1", "Twist", "snake_case"}) {
        EXPECT_TRUE(is_identifier(name)) << name;
    }
    for (const auto* name : {"", "1a", "a-b", "a b", "é", "a.b", "a\n"}) {
        EXPECT_FALSE(is_identifier(name)) << name;
    }
}

} // namespace
} // namespace isomotion::formula
