#include <cmath>

#include "animation/animation.h"
#include "testing.h"

namespace isomotion::animation {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Arrays, FieldsKnowTimeIndexAndCount) {
    const Animation animation(
        {}, {{"blobs", 4, {field("a", "i"), field("b", "n"), field("c", "100*t + 10*n + i")}}});
    EXPECT_THAT(column(animation, 0, 0.5), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(column(animation, 1, 0.5), ElementsAre(4, 4, 4, 4));
    EXPECT_THAT(column(animation, 2, 0.5), ElementsAre(90, 91, 92, 93));
    EXPECT_EQ(animation.at(0).arrays.at(0).count, 4);
}

TEST(Arrays, FieldsAreNumbersAndListsToo) {
    const Animation animation(
        {}, {{"blobs", 3, {{"weight", 0.1}, {"r", std::vector<double>{3, 1, 2}}}}});
    EXPECT_THAT(column(animation, 0, 7), ElementsAre(0.1, 0.1, 0.1));
    EXPECT_THAT(column(animation, 1, 7), ElementsAre(3, 1, 2));
}

TEST(Arrays, FieldsNameSiblingsInAnyOrderAndTracks) {
    const Animation animation({{"m", 10.0}}, {{"blobs",
                                               3,
                                               {field("a", "b + m"),
                                                field("b", "2*c + w"),
                                                {"c", std::vector<double>{5, 6, 7}},
                                                {"w", 0.5}}}});
    EXPECT_THAT(column(animation, 0, 0), ElementsAre(20.5, 22.5, 24.5));
    EXPECT_THAT(column(animation, 1, 0), ElementsAre(10.5, 12.5, 14.5));
}

TEST(Arrays, RandomNumbersArePinned) {
    const Animation animation({}, {{"blobs", 2, {field("r", "random(i, 0)")}}});
    EXPECT_THAT(column(animation, 0, 0), ElementsAre(0.65244848637403219, 0.55272679084691956));
    EXPECT_EQ(column(animation, 0, 0), column(animation, 0, 99));
    const Animation other({}, {{"blobs", 2, {field("r", "random(i, 0)")}}}, 1);
    EXPECT_EQ(column(other, 0, 0)[0], 0.36818951565166946);
}

TEST(Arrays, MayBeEmpty) {
    const Animation animation(
        {}, {{"blobs", 0, {field("a", "1/i"), {"b", 2.0}, {"c", std::vector<double>{}}}}});
    const Values values = animation.at(1);
    EXPECT_EQ(values.arrays.at(0).count, 0);
    EXPECT_THAT(values.arrays.at(0).fields, ElementsAre(IsEmpty(), IsEmpty(), IsEmpty()));
}

TEST(Arrays, MayBeLong) {
    constexpr int count = 5000;
    const Animation animation({}, {{"blobs", count, {field("a", "i + t"), field("b", "n - a")}}});
    const auto b = column(animation, 1, 0.5);
    ASSERT_EQ(b.size(), std::size_t(count));
    for (int i = 0; i < count; ++i) ASSERT_EQ(b[std::size_t(i)], count - i - 0.5) << i;
}

TEST(Arrays, KeepTheirFieldsApart) {
    const Animation animation({}, {{"blobs", 2, {field("r", "i + 1")}},
                                   {"links", 3, {field("r", "10*i"), field("s", "r + 1")}}});
    const Values values = animation.at(0);
    EXPECT_THAT(values.arrays.at(0).fields.at(0), ElementsAre(1, 2));
    EXPECT_THAT(values.arrays.at(1).fields.at(0), ElementsAre(0, 10, 20));
    EXPECT_THAT(values.arrays.at(1).fields.at(1), ElementsAre(1, 11, 21));
}

TEST(Arrays, WrongFieldsAreNamedWithTheirArray) {
    const auto wrong = [](std::vector<ArrayField> fields) {
        return complaint({{"speed", 1.0}}, {{"blobs", 2, std::move(fields)}});
    };
    EXPECT_EQ(wrong({field("cx", "i +")}).owner, "blobs.cx");
    EXPECT_EQ(wrong({{"r", 1.0}, field("cx", "x")}).owner, "blobs.cx");
    EXPECT_THAT(wrong({field("cx", "spede")}).message, HasSubstr("did you mean 'speed'?"));
    EXPECT_THAT(wrong({{"radius", 1.0}, field("cx", "radus")}).message,
                HasSubstr("did you mean 'radius'?"));

    const Complaint own = wrong({field("cx", "cx + 1")});
    EXPECT_EQ(own.owner, "blobs.cx");
    EXPECT_EQ(own.message, "the value of 'blobs.cx' depends on itself");
    EXPECT_THAT(wrong({field("a", "b"), field("b", "a")}).message, HasSubstr("depends on itself"));
}

TEST(Arrays, TracksCannotNameFields) {
    EXPECT_EQ(complaint({track("m", "r")}, {{"blobs", 2, {{"r", 1.0}}}}).owner, "m");
}

// What names neither i nor n nor a sibling has one value, with or without an element.
TEST(StandsAlone, IsReadOffTheSource) {
    const Array array{"blobs",
                      4,
                      {{"number", 2.0},
                       {"list", std::vector<double>{1, 2, 3, 4}},
                       field("time", "2*t"),
                       field("track", "m + sin(pi)"),
                       field("index", "2*i"),
                       field("count", "1/n"),
                       field("sibling", "2*number"),
                       field("itself", "itself + 1"),
                       field("noise", "random(3, 1)"),
                       field("noise_index", "random(i, 1)"),
                       field("word", "list1 + in + numbers")}};
    const bool expected[] = {true,  false, true, true,  false, false,
                             false, false, true, false, true};
    ASSERT_EQ(std::size(expected), array.fields.size());
    for (std::size_t f = 0; f < array.fields.size(); ++f) {
        EXPECT_EQ(stands_alone(array, f), expected[f]) << array.fields[f].name;
    }
}

// It is not searched for names, but refused.
TEST(StandsAlone, WhatIsTooLongDoesNot) {
    const Array array{"blobs", 4, {field("long", "2*t" + std::string(500'000, ' '))}};
    EXPECT_FALSE(stands_alone(array, 0));
    try {
        Animation({}, {array});
        FAIL();
    } catch (const ExpressionError& error) {
        EXPECT_EQ(error.owner(), "blobs.long");
        EXPECT_THAT(error.what(), HasSubstr("the formula has 500003 bytes; at most 500000"));
    }
}

// What the words say is what the values do.
TEST(StandsAlone, AgreesWithTheValues) {
    const Array array{"blobs",
                      5,
                      {field("a", "i*i - t"), field("b", "3*t"), field("c", "random(2, 2)"),
                       field("d", "random(i, 2)")}};
    const Values values = Animation({}, {array}).at(0.5);
    for (std::size_t f = 0; f < array.fields.size(); ++f) {
        const auto& column = values.arrays[0].fields[f];
        if (stands_alone(array, f)) {
            EXPECT_THAT(column, Each(column[0])) << array.fields[f].name;
        } else {
            EXPECT_THAT(column, testing::Not(Each(column[0]))) << array.fields[f].name;
        }
    }
}

} // namespace
} // namespace isomotion::animation
