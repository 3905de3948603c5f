#include "sequence/frame_status.h"

#include <chrono>

#include "records.h"

namespace isomotion::sequence {
namespace {

namespace fs = std::filesystem;

class FrameStatusTest : public Recorded {
protected:
    FrameStatus of(const FrameRecord& record) const {
        return frame_status(file_, record, record.fingerprint, "0.1.0");
    }
    const FrameRecord record_ = write(1);
    const fs::path file_ = name().path(1);
};

TEST_F(FrameStatusTest, AWholeFileIsWhole) { EXPECT_EQ(of(record_), FrameStatus::whole); }

TEST_F(FrameStatusTest, EveryChangedByteShows) {
    const auto bytes = base::read_whole(file_);
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        auto changed = bytes;
        changed[k] ^= std::byte{1};
        base::write_whole(file_, changed);
        EXPECT_EQ(of(record_), FrameStatus::changed) << k;
    }
    for (const std::size_t size : {std::size_t(0), std::size_t(1), bytes.size() - 1}) {
        base::write_whole(file_, std::span(bytes).first(size));
        EXPECT_EQ(of(record_), FrameStatus::changed) << size;
    }
    base::write_whole(file_, bytes);
    EXPECT_EQ(of(record_), FrameStatus::whole);
}

TEST_F(FrameStatusTest, DatesDoNotCount) {
    for (const int years : {-50, 50}) {
        fs::last_write_time(file_, fs::file_time_type::clock::now() + std::chrono::years(years));
        EXPECT_EQ(of(record_), FrameStatus::whole);
    }
}

TEST_F(FrameStatusTest, TellsWhy) {
    EXPECT_EQ(frame_status(file_, record_, "another", "0.1.0"), FrameStatus::stale);
    EXPECT_EQ(frame_status(file_, record_, "another", "0.2.0"), FrameStatus::outdated);
    EXPECT_EQ(frame_status(file_, record_, record_.fingerprint, "0.2.0"), FrameStatus::whole);
    EXPECT_EQ(frame_status(file_, {}, record_.fingerprint, "0.1.0"), FrameStatus::foreign);
    fs::remove(file_);
    EXPECT_EQ(of(record_), FrameStatus::missing);
    EXPECT_EQ(frame_status(file_, {}, "x", "0.1.0"), FrameStatus::missing);
    fs::create_directory(file_);
    EXPECT_EQ(of(record_), FrameStatus::changed);
}

} // namespace
} // namespace isomotion::sequence
