#include "sequence/manifest_json.h"

#include <cmath>
#include <limits>
#include <random>

#include "records.h"

namespace isomotion::sequence {
namespace {

TEST(ManifestJson, GivesBackWhatWasPutIn) {
    const Sequence sequence = some_sequence({1, 2, 3, 7, 9, 11, 4000});
    const Sequence back = parse_sequence(to_json(sequence), "a");
    EXPECT_EQ(difference(sequence, back), "");
    EXPECT_EQ(back.asked, sequence.asked);
    EXPECT_EQ(back.backend, sequence.backend);
    EXPECT_EQ(to_json(back), to_json(sequence));

    FrameRecord record;
    record.frame = 812;
    record.file = "a.0812.png";
    record.bytes = 123'456'789'012;
    record.time = 27.033333333333335;
    record.parameters = {{"m", 1.0 / 3.0}, {"r", 1e-300}};
    record.verdicts = {1, 2, 3, 4, 5};
    record.proofs = render::ProofCounts{1, 2, 3, 4, 5, 6, 7};
    record.evaluations = 9'007'199'254'740'993; // no double has it
    const FrameRecord again = parse_frame_record(to_json(record), "a");
    EXPECT_EQ(to_json(again), to_json(record));
    EXPECT_EQ(again.bytes, record.bytes);
    EXPECT_EQ(again.parameters, record.parameters);
    EXPECT_EQ(again.proofs, record.proofs);
    EXPECT_EQ(again.evaluations, record.evaluations);
}

TEST(ManifestJson, KeepsNamesThatNeedCare) {
    Sequence sequence = some_sequence();
    for (const std::string title : {"a \"b\" \\ c\n", "h\u00e9llo", "\xff not UTF-8", ""}) {
        sequence.title = title;
        const Sequence back = parse_sequence(to_json(sequence), "a");
        EXPECT_EQ(difference(back, parse_sequence(to_json(back), "a")), "");
    }
}

TEST(ManifestJson, SaysNothingThatATerminalObeys) {
    const auto replaced = [](const char* from, const char* to) {
        std::string text = to_json(some_sequence());
        const std::size_t at = text.find(from);
        return text.replace(at, std::string(from).size(), to);
    };
    EXPECT_NO_THROW(parse_sequence(replaced("Sphere", "Ball"), "a"));
    for (const char* text : {"Sphere\\n  whole", "\\u001b[2J", "a\\rb", "\\u202ea", "\\u0007"}) {
        EXPECT_THROW(parse_sequence(replaced("Sphere", text), "a"), Error) << text;
        EXPECT_THROW(parse_sequence(replaced("llvmpipe", text), "a"), Error) << text;
        EXPECT_THROW(parse_sequence(replaced("0.1.0", text), "a"), Error) << text;
    }
    EXPECT_THROW(parse_sequence(replaced("Sphere", std::string(5000, 'x').c_str()), "a"), Error);
}

TEST(ManifestJson, RefusesCountsThatNoFrameHas) {
    const std::string whole = to_json(FrameRecord{});
    for (const char* number : {"-1", "9223372036854775807", "1e300", "18446744073709551616"}) {
        std::string text = whole;
        const std::string key = "\"evaluations\": 0";
        text.replace(text.find(key), key.size(), std::string("\"evaluations\": ") + number);
        EXPECT_THROW(parse_frame_record(text, "a"), Error) << number;
    }
}

TEST(ManifestJson, AValueThatIsNoneStaysNone) {
    FrameRecord record;
    record.parameters = {{"a", std::numeric_limits<double>::quiet_NaN()}};
    EXPECT_TRUE(std::isnan(parse_frame_record(to_json(record), "a").parameters[0].second));
}

// A record that a crash cut off, or that somebody edited, is none; it never ends the program.
TEST(ManifestJson, WhatIsCutOffOrDamagedIsRefused) {
    const std::string whole = to_json(some_sequence()), frame = to_json(FrameRecord{});
    for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
        EXPECT_THROW(parse_sequence(whole.substr(0, length), "a"), Error) << length;
    }
    EXPECT_THROW(parse_sequence(frame, "a"), Error);
    EXPECT_THROW(parse_frame_record(whole, "a"), Error);
    for (const char* text : {"", "[]", "3", "null", "{}", R"({"format": 3})"}) {
        EXPECT_THROW(parse_sequence(text, "a"), Error) << text;
    }
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 2000; ++round) {
        std::string damaged = frame;
        damaged[random() % damaged.size()] = char(random() % 256);
        try {
            parse_frame_record(damaged, "a");
        } catch (const Error&) {
        }
    }
}

} // namespace
} // namespace isomotion::sequence
