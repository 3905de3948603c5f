#include "testing.h"

namespace isomotion::scene {
namespace {

class ArrayMistakes : public Scenes {
protected:
    void expect(const std::string& array, const std::string& message) const {
        EXPECT_EQ(mistake(blobs(array)), "scene.toml:" + message) << array;
    }
};

TEST_F(ArrayMistakes, Counts) {
    EXPECT_EQ(mistake(blobs("count = 3\ncx = \"i\"\nw = 1")), "nothing is wrong");
    expect("cx = \"i\"\nw = 1",
           "4: arrays.blobs: needs count, the number of elements, or file, a table of them");
    for (const char* count : {"-1", "1000001", "2.0", "\"3\"", "\"n\"", "[3]"}) {
        expect(std::string("cx = 1\nw = 1\ncount = ") + count,
               "7: arrays.blobs.count: must be an integer from 0 to 1000000");
    }
}

TEST_F(ArrayMistakes, Lists) {
    expect("count = 3\ncx = [1, 2]\nw = 1",
           "6: arrays.blobs.cx: has 2 values for 3 elements; give one for each");
    expect("count = 0\nw = 1\ncx = [1]",
           "7: arrays.blobs.cx: has 1 values for 0 elements; give one for each");
    expect("count = 3\ncx = [1, \"i\", 2]\nw = 1", "6: arrays.blobs.cx[1]: must be a number");
    expect("count = 3\ncx = [1,\n2,\nnan]\nw = 1", "8: arrays.blobs.cx[2]: must be finite");
}

TEST_F(ArrayMistakes, FieldsOfTheWrongType) {
    for (const char* value : {"true", "{ keys = [[0, 1]] }", "1979-05-27"}) {
        expect(std::string("count = 3\nw = 1\ncx = ") + value,
               "7: arrays.blobs.cx: must be a number, an expression in t, i and n, or a list of "
               "numbers");
    }
    expect("count = 3\nw = 1\ncx = inf", "7: arrays.blobs.cx: must be finite");
}

TEST_F(ArrayMistakes, Expressions) {
    expect("count = 3\nw = 1\ncx = \"2*j\"",
           "7: arrays.blobs.cx: unknown name 'j'; known: t, i, n, cx, w, pi\n"
           "    2*j\n"
           "      ^");
    expect("count = 3\nw = 1\ncx = \"ww + 1\"",
           "7: arrays.blobs.cx: unknown name 'ww'; did you mean 'w'?\n"
           "    ww + 1\n"
           "    ^");
    expect("count = 3\ncx = \"2*cx\"\nw = 1",
           "6: arrays.blobs.cx: the value of 'blobs.cx' depends on itself");
    expect("count = 3\ncx = \"i/0\"\nw = 1", "6: arrays.blobs.cx: division by zero\n"
                                             "    i/0\n"
                                             "     ^");
}

TEST_F(ArrayMistakes, Names) {
    expect("count = 3\nw = 1\ncx = 1\nx = 1",
           "8: arrays.blobs.x: 'x' already has a meaning in formulas; choose another name");
    expect(
        "count = 3\nw = 1\ncx = 1\nn = 1",
        "8: arrays.blobs.n: 'n' means the number of elements in expressions; choose another name");
    expect("count = 3\nw = 1\ncx = 1\n\"c x\" = 1",
           "8: arrays.blobs.\"c x\": a name is letters, digits and _, and starts with a letter");
    expect("count = 3\nw = 1\ncx = 1\n[arrays.sum]\ncount = 1",
           "8: arrays.sum: 'sum' already has a meaning in formulas; choose another name");
}

TEST_F(ArrayMistakes, FieldsThatTheFormulaMisses) {
    EXPECT_THAT(mistake(blobs("count = 3\nw = 1")),
                testing::StartsWith("scene.toml:2: surface.formula: unknown name 'cx'; "));
    EXPECT_THAT(mistake(ball_with(6, "formula = \"sum(blobs, x) - radius\"")),
                testing::StartsWith("scene.toml:6: surface.formula: sum needs an array, and the "
                                    "scene has none: add [arrays.name]\n"));
}

TEST_F(ArrayMistakes, FieldsThatNothingUses) {
    expect("count = 3\nw = 1\ncx = 1\nspeed = 2",
           "8: arrays.blobs.speed: neither the formula nor another field uses this field");
    expect("count = 3\nw = 1\ncx = 1\ncxx = \"i\"",
           "8: arrays.blobs.cxx: nothing uses this field; did you mean 'cx'?");
    EXPECT_EQ(mistake(blobs("count = 3\nw = 1\ncx = \"speed*t\"\nspeed = \"i\"")),
              "nothing is wrong");
    // An array that waits for a formula to sum over it is no slip.
    EXPECT_EQ(mistake(ball_and("[arrays.blobs]\ncount = 2\ncx = 1")), "nothing is wrong");
}

TEST_F(ArrayMistakes, MoreArraysThanAFormulaCanSumOver) {
    std::string text = ball();
    for (int k = 0; k < formula::max_arrays; ++k) {
        text += "[arrays.a" + std::to_string(k) + "]\ncount = 1\n";
    }
    EXPECT_EQ(mistake(text), "nothing is wrong");
    EXPECT_THAT(mistake(text + "[arrays.more]\ncount = 1\n"),
                testing::EndsWith(": arrays: a scene has at most 32 arrays"));
}

} // namespace
} // namespace isomotion::scene
