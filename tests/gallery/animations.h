// All animations of animations/, dealt out so that test runners can share the work.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/data_folder.h"

namespace isomotion {

inline constexpr int shards = 8;

// Every eighth animation by name, from the shard's number on. Slow ones spread by chance.
inline std::vector<std::string> animations_of(int shard) {
    const auto all = scene::animation_names();
    std::vector<std::string> some;
    for (std::size_t k = std::size_t(shard); k < all.size(); k += shards) some.push_back(all[k]);
    return some;
}

class EveryAnimation : public testing::TestWithParam<int> {};

#define ISOMOTION_ON_EVERY_ANIMATION(suite)                                                        \
    INSTANTIATE_TEST_SUITE_P(Shards, suite, testing::Range(0, isomotion::shards))

} // namespace isomotion
