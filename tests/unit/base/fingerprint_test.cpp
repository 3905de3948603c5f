#include "base/fingerprint.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using isomotion::base::Fingerprint;

namespace {

std::string by_words(const std::vector<std::byte>& bytes) {
    return Fingerprint().add_words(bytes).text();
}

} // namespace

TEST(Fingerprint, EachBitOfWordsCounts) {
    for (const std::size_t length : {1, 7, 8, 9, 24}) {
        std::vector<std::byte> bytes(length, std::byte{0x5a});
        std::set<std::string> texts{by_words(bytes)};
        for (std::size_t bit = 0; bit < 8 * length; ++bit) {
            std::vector<std::byte> changed = bytes;
            changed[bit / 8] ^= std::byte(1 << (bit % 8));
            texts.insert(by_words(changed));
        }
        EXPECT_EQ(texts.size(), 8 * length + 1) << length << " bytes";
    }
}

// A last word that is not full is no word with zeros.
TEST(Fingerprint, LengthsOfWordsCount) {
    std::set<std::string> texts;
    for (std::size_t length = 0; length <= 17; ++length)
        texts.insert(by_words(std::vector<std::byte>(length)));
    EXPECT_EQ(texts.size(), 18u);
}

TEST(Fingerprint, OrderCounts) {
    std::vector<std::byte> bytes(16);
    bytes[0] = std::byte{1};
    std::vector<std::byte> swapped(16);
    swapped[8] = std::byte{1};
    EXPECT_NE(by_words(bytes), by_words(swapped));
}
