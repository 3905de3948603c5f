#include "sequence/standing.h"

#include <chrono>

#include "records.h"

namespace isomotion::sequence {
namespace {

namespace fs = std::filesystem;

class StandingTest : public Recorded {
protected:
    Standing of(const FrameRecord& record) const {
        return standing(file_, record, record.fingerprint);
    }
    const FrameRecord record_ = write(1);
    const fs::path file_ = name().path(1);
};

TEST_F(StandingTest, AWholeFileIsWhole) { EXPECT_EQ(of(record_), Standing::whole); }

TEST_F(StandingTest, EveryChangedByteShows) {
    const auto bytes = base::read_whole(file_);
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        auto changed = bytes;
        changed[k] ^= std::byte{1};
        base::write_whole(file_, changed);
        EXPECT_EQ(of(record_), Standing::changed) << k;
    }
    for (const std::size_t size : {std::size_t(0), std::size_t(1), bytes.size() - 1}) {
        base::write_whole(file_, std::span(bytes).first(size));
        EXPECT_EQ(of(record_), Standing::changed) << size;
    }
    base::write_whole(file_, bytes);
    EXPECT_EQ(of(record_), Standing::whole);
}

TEST_F(StandingTest, DatesDoNotCount) {
    for (const int years : {-50, 50}) {
        fs::last_write_time(file_, fs::file_time_type::clock::now() + std::chrono::years(years));
        EXPECT_EQ(of(record_), Standing::whole);
    }
}

TEST_F(StandingTest, TellsWhy) {
    EXPECT_EQ(standing(file_, record_, "another"), Standing::stale);
    EXPECT_EQ(standing(file_, {}, record_.fingerprint), Standing::foreign);
    fs::remove(file_);
    EXPECT_EQ(of(record_), Standing::missing);
    EXPECT_EQ(standing(file_, {}, "x"), Standing::missing);
    fs::create_directory(file_);
    EXPECT_EQ(of(record_), Standing::changed);
}

} // namespace
} // namespace isomotion::sequence
