#include "base/write_at_once.h"

#include <array>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace isomotion::base {
namespace {

TEST(WriteAtOnce, WaitsForNobody) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const auto [from, to] = pipe;
    write_at_once(to, "words\n");
    std::array<char, 16> read{};
    ASSERT_EQ(::read(from, read.data(), read.size()), 6);
    EXPECT_EQ(std::string(read.data()), "words\n");

    ASSERT_EQ(::fcntl(to, F_SETFL, O_NONBLOCK), 0);
    const std::string much(4096, '.');
    while (::write(to, much.data(), much.size()) > 0) {
    } // until it is full
    ASSERT_EQ(::fcntl(to, F_SETFL, 0), 0);
    write_at_once(to, "words\n"); // comes back
    ::close(from);
    ::close(to);
    write_at_once(to, "words\n"); // to what is closed, too
}

} // namespace
} // namespace isomotion::base
