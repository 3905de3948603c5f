// Timelines as files: what is written reads back equal, and what is broken is told where.
#include "topology/timeline/timeline_file.h"

#include <bit>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/input_error.h"
#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string mistake(const std::string& text) {
    try {
        parse_timeline(text, "a.json");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "no mistake";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return at == text.npos ? text : text.replace(at, from.size(), to);
}

// Any bits that are an interval: unbounded, subnormal, negative zero.
formula::Interval any_interval(std::mt19937_64& random) {
    const auto any = [&] {
        switch (random() % 8) {
        case 0:
            return -0.0;
        case 1:
            return formula::smallest_positive * double(random() % 9);
        default:
            break;
        }
        const double value = std::bit_cast<double>(random());
        return std::isnan(value) ? 1.0 / 3 : value;
    };
    formula::Interval found{any(), any()};
    if (found.lo > found.hi) std::swap(found.lo, found.hi);
    if (found.lo == formula::infinity) found.lo = 0;
    if (found.hi == -formula::infinity) found.hi = 0;
    return found;
}

std::string any_text(std::mt19937_64& random) {
    const char* parts[] = {"a", "\"", "\\", "\u00DF", "/", "ü", "\xF0\x9F\x8C\x80", " ", "{", "]"};
    std::string text;
    for (std::uint64_t k = random() % 6; k > 0; --k) text += parts[random() % 10];
    return text;
}

std::optional<Betti> any_betti(std::mt19937_64& random) {
    if (random() % 4 == 0) return std::nullopt;
    return Betti{1 + int(random() % 1000), int(random() % 3), int(random() % 1'000'000)};
}

TimelineRecord any_record(std::mt19937_64& random) {
    TimelineRecord record =
        ten_a_second().title.empty() ? TimelineRecord{} : TimelineRecord{ten_a_second(), {}};
    record.header.title = any_text(random);
    record.header.fps = {std::int64_t(1 + random() % 100'000), std::int64_t(1 + random() % 2000)};
    record.header.shape = scene::Bounds::Shape(random() % 2);
    for (auto& side : record.header.end_bounds) side = any_interval(random);
    for (std::uint64_t k = random() % 3; k > 0; --k)
        record.header.solids.push_back(random() % 2 ? 1 : -1);
    Timeline& timeline = record.timeline;
    std::uniform_real_distribution<double> time(-10, 10);
    timeline.range = {time(random) - 20, time(random) + 20};
    timeline.is_proved = random() % 2;
    for (std::uint64_t k = random() % 3; k > 0; --k) timeline.doubts.push_back(any_text(random));
    if ((timeline.start = any_betti(random))) timeline.start_is_proved = random() % 2;
    if ((timeline.end = any_betti(random))) timeline.end_is_proved = random() % 2;
    std::vector<double> times(random() % 20);
    for (double& t : times) t = time(random);
    std::sort(times.begin(), times.end());
    for (const double t : times) {
        Event event;
        event.time = {t, std::nextafter(t, 99)};
        for (auto& side : event.where) side = any_interval(random);
        event.stratum = int(random() % 4);
        event.index = int(random() % std::uint64_t(event.stratum + 1));
        event.grows = random() % 2;
        event.kind = Kind(random() % (std::uint64_t(Kind::none) + 1));
        event.is_proved = random() % 2;
        event.is_proved_again = random() % 2;
        event.kind_proof = any_text(random);
        event.before = any_betti(random);
        event.after = any_betti(random);
        if (random() % 3 == 0) {
            timeline.unresolved.push_back(
                {event.time, event.where, any_text(random), event.before, event.after});
        } else {
            timeline.events.push_back(event);
        }
    }
    return record;
}

TEST(TimelineFile, ReadsBackWhatWasWritten) {
    const std::uint64_t seed = 4711;
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 500; ++trial) {
        const TimelineRecord record = any_record(random);
        const std::string text = to_json(record);
        TimelineRecord back;
        ASSERT_NO_THROW(back = parse_timeline(text, "a.json")) << seed << ' ' << trial << '\n'
                                                               << text;
        // parse_frame_rate cancels the fraction.
        back.header.fps = record.header.fps;
        ASSERT_EQ(back, record) << seed << ' ' << trial << '\n' << text;
    }
    EXPECT_EQ(parse_timeline(to_json(story()), ""), story());
}

TEST(TimelineFile, SaysWhichSideIsTheSolid) {
    TimelineRecord record = story();
    EXPECT_THAT(to_json(record), testing::Not(HasSubstr("\n  \"solid\""))) << "as before";
    record.header.solids = {1};
    const std::string text = to_json(record);
    EXPECT_THAT(text, HasSubstr("\n  \"solid\": \"F > 0\",\n"));
    EXPECT_THAT(mistake(replaced(text, "\"F > 0\"", "\"F = 0\"")),
                HasSubstr("solid: must be \"F < 0\" or \"F > 0\""));
    EXPECT_THAT(mistake(replaced(text, "\"F > 0\"", "[\"F > 0\"]")),
                HasSubstr("solid: must be a list of 2"));
    record.header.solids = {1, -1};
    EXPECT_THAT(to_json(record), HasSubstr("\"solid\": [\"F > 0\",\"F < 0\"],"));
}

TEST(TimelineFile, SaysForReadersWhereAndWhen) {
    const std::string text = to_json(story());
    EXPECT_THAT(text, StartsWith("{\n  \"format\": \"isomotion topology timeline\",\n"
                                 "  \"version\": 1,\n"));
    EXPECT_THAT(text, HasSubstr("\"frames\": [1.0,101.0],\n  \"complete\": true,"));
    EXPECT_THAT(text, HasSubstr("{\"frame\":10.5,\"kind\":\"merge\","));
    EXPECT_THAT(text, HasSubstr("\"before\":{\"solid\":[1,1,0],\"surface\":[1,2,1]}"));
    // One event a line.
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 21);
}

// Nothing but the whole of it is a timeline.
TEST(TimelineFile, IsNoTimelineWhenCutOff) {
    const std::string text = to_json(story());
    for (std::size_t length = 0; length + 2 < text.size(); ++length) {
        ASSERT_THAT(mistake(text.substr(0, length)), StartsWith("a.json: not valid JSON: "))
            << length;
    }
}

// Whatever is done to the bytes, it reads as some timeline or is refused in words.
TEST(TimelineFile, NoDamageIsMoreThanAMistake) {
    const std::uint64_t seed = 99;
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::string whole = to_json(story());
    int refused = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        std::string text = whole;
        for (std::uint64_t k = 1 + random() % 3; k > 0; --k) {
            const std::size_t at = random() % text.size();
            switch (random() % 3) {
            case 0:
                text[at] = char(random() % 256);
                break;
            case 1:
                text.erase(at, 1 + random() % 20);
                break;
            default:
                text.insert(at, whole.substr(random() % whole.size(), random() % 40));
            }
        }
        const std::string message = mistake(text);
        if (message == "no mistake") continue;
        EXPECT_THAT(message, StartsWith("a.json:"));
        ++refused;
    }
    EXPECT_GT(refused, 2000);
}

TEST(TimelineFile, MistakesNameTheKey) {
    const std::string right = to_json(story());
    const struct {
        const char *from, *to, *message;
    } wrongs[] = {
        {"isomotion topology timeline", "a poem", "a.json:2: format: is 'a poem'; a timeline's is"},
        {"\"version\": 1", "\"version\": 2", "a.json:3: version: is 2, which this program cannot"},
        {"\"version\": 1", "\"version\": \"1\"", "version: must be a whole number from 1 to"},
        {"\"version\": 1", "\"version\": 1e99", "version: must be a whole number"},
        {"\"version\": 1", "\"version\": 99999999999999999999", "version: must be a whole number"},
        {"\"version\": 1,", "", "a.json: has no key 'version', which it needs"},
        {"\"version\": 1", "\"version\": 1, \"version\": 1", "version: is given twice"},
        {"\"none_missing\"", "\"none_mising\"", "has no key 'none_missing'"},
        {"\"complete\": true", "\"complete\": false", "complete: contradicts the rest"},
        {"\"complete\": true", "\"complete\": 1", "complete: must be true or false"},
        {"\"complete\"", "\"complet\"", "complet: unknown key; did you mean 'complete'?"},
        {"\"10\"", "\"0\"", "frames_per_second: must be a rate above 0"},
        {"\"10\"", "10", "frames_per_second: must be a text"},
        {"\"shape\":\"box\"", "\"shape\":\"cube\"", "bounds.shape: must be \"box\" or \"sphere\""},
        {"[[-1.0,1.0],", "[[1.0,-1.0],", "bounds.start[0]: must be [lo, hi] with lo not above hi"},
        {"[[-1.0,1.0],", "[", "bounds.start: must be a list of 3"},
        {"\"time\": [0.0,10.0]", "\"time\": [0.0,null]", "time: must be [first, last] in seconds"},
        {"\"frames\": [1.0,101.0]", "\"frames\": [1.0,51.0]", "frames: contradicts 'time'"},
        {"\"merge\"", "\"mege\"", "events[0].kind: there is no kind 'mege'; known: unknown, birth"},
        {"\"direction\":\"grows\"", "\"direction\":\"up\"", "events[0].direction: must be \"grows"},
        {"\"frame\":20.25", "\"frame\":21", "events[1].frame: contradicts 'time', which is at fra"},
        {"\"point\":[0.5", "\"point\":[0.6", "events[0].point[0]: contradicts 'where', whose mid"},
        {"\"radius\":", "\"radius\":5", "events[0].radius: contradicts 'where'"},
        {"\"stratum\":3", "\"stratum\":4", "events[0].stratum: must be a whole number from 0 to 3"},
        {"\"index\":1", "\"index\":-1", "events[0].index: must be a whole number from 0 to 3"},
        {"\"index\":1", "\"index\":1.0", "events[0].index: must be a whole number"},
        {"\"solid\":[2,0,0]", "\"solid\":[2,0]", "events[0].after.solid: must be a list of 3"},
        {"\"solid\":[2,0,0]", "\"solid\":[2,0,-1]", "events[0].after.solid[2]: must be a whole n"},
        {"\"solid\":[2,0,0]", "\"solid\":[5,0,0]",
         "events[0].after.surface: contradicts the solid"
         "'s; its surface has [5,0,5]"},
        {"\"solid\":[2,0,0],\"surface\":[2,0,2]", "\"solid\":[0,1,0],\"surface\":[0,2,0]",
         "events[0].after.solid: cannot be: without a component"},
        {"\"unresolved\": []", "\"unresolved\": {}", "unresolved: must be a list, in [ ]"},
        {"\"unresolved\": []", "\"unresolved\": [3]", "unresolved[0]: must be an object, in { }"},
        {"\"doubts\": []", "\"doubts\": [null]", "doubts[0]: must be a text"},
        {"\"doubts\": []", "\"doubts\": [\"\\u001b[2J\"]", "doubts[0]: must be one printable line"},
        {"\"kind_proof\":\"", "\"kind_proof\":\"\\n", "kind_proof: must be one printable line"},
        {"\"title\":\"", "\"title\":\"\\r", "scene.title: must be one printable line"},
    };
    for (const auto& wrong : wrongs) {
        EXPECT_THAT(mistake(replaced(right, wrong.from, wrong.to)), HasSubstr(wrong.message))
            << wrong.to;
    }
    for (const char* text : {"", "[]", "null", "7", "\"x\"", "{}", "{\"format\":", "\xFF\xFE"}) {
        EXPECT_THAT(mistake(text), StartsWith("a.json: ")) << text;
    }
    EXPECT_THAT(mistake(std::string(200'000, '[')), HasSubstr("lists are nested too deeply; 64"));
    TimelineRecord record = story();
    std::swap(record.timeline.events[1], record.timeline.events[2]);
    EXPECT_THAT(mistake(to_json(record)),
                HasSubstr("events[2]: comes before one above it; sort by time"));
}

TEST(TimelineFile, AMissingFileIsTold) {
    EXPECT_THROW(
        {
            try {
                read_timeline("/nowhere/a.json");
            } catch (const base::InputError& error) {
                EXPECT_THAT(error.what(), StartsWith("/nowhere/a.json: no such file"));
                throw;
            }
        },
        base::InputError);
    EXPECT_THROW(read_timeline("/"), base::InputError);
}

// What was written for readers may be left out by those who write a file themselves.
TEST(TimelineFile, DerivedNumbersMayBeLeftOut) {
    std::string text = to_json(story());
    text = replaced(text, "\"frame\":10.5,", "");
    text = replaced(text, "\"complete\": true,", "");
    text = replaced(text, ",\"surface\":[3,0,3]", "");
    text = replaced(text, "\"frames\": [1.0,101.0],", "");
    EXPECT_EQ(parse_timeline(text, "a.json"), story());
}

} // namespace
} // namespace isomotion::topology
