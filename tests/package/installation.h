// The build, installed into a folder of its own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"
#include "unit/image/places.h"

namespace isomotion::package {

class Installation : public testing::Test {
protected:
    // Once for all tests of a fixture: each installs the same.
    static void SetUpTestSuite() {
        folder_ = std::make_unique<image::TemporaryFolder>();
        const cli::Ending ending =
            cli::run({CMAKE_PROGRAM, "--install", ISOMOTION_BUILD_DIR, "--prefix", prefix()}, {});
        ASSERT_EQ(ending.code, 0) << ending;
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static std::filesystem::path prefix() { return *folder_ / "prefix"; }
    static std::filesystem::path share() { return prefix() / "share"; }

    // Fails unless the program ends with 0.
    static cli::Ending done(const std::vector<std::string>& words,
                            const cli::Circumstances& circumstances = {}) {
        const cli::Ending ending = cli::run(words, circumstances);
        EXPECT_EQ(ending.code, 0) << words.front() << ": " << ending;
        return ending;
    }

private:
    static inline std::unique_ptr<image::TemporaryFolder> folder_;
};

} // namespace isomotion::package
