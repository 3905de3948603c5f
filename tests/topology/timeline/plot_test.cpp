// The picture of a timeline as text: well formed, with everything in it and nothing outside.
#include "topology/timeline/plot.h"

#include <map>

#include <gmock/gmock.h>

#include "topology/timeline/representative_frames.h"
#include "topology/timeline/svg.h"
#include "topology/timeline/svg_elements.h"
#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using testing::HasSubstr;
using testing::Not;

void expect_well_formed(const std::string& svg) {
    EXPECT_FALSE(elements_of(svg).empty());
    for (std::size_t at = svg.find('&'); at != svg.npos; at = svg.find('&', at + 1)) {
        const std::string_view rest = std::string_view(svg).substr(at);
        EXPECT_TRUE(rest.starts_with("&amp;") || rest.starts_with("&lt;") ||
                    rest.starts_with("&gt;") || rest.starts_with("&quot;"))
            << rest.substr(0, 20);
    }
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

// What DejaVu Sans takes for a character, of the font's size (its advance widths).
double advance(char c) {
    static const std::map<char, double> widths{
        {' ', .318}, {'(', .39},  {')', .39},  {',', .318}, {'-', .361}, {'.', .318}, {':', .337},
        {'>', .838}, {'<', .838}, {'&', .78},  {'"', .46},  {'a', .613}, {'b', .635}, {'c', .55},
        {'d', .635}, {'e', .615}, {'f', .352}, {'g', .635}, {'h', .634}, {'i', .278}, {'j', .278},
        {'k', .579}, {'l', .278}, {'m', .974}, {'n', .634}, {'o', .612}, {'p', .635}, {'q', .635},
        {'r', .411}, {'s', .521}, {'t', .392}, {'u', .634}, {'v', .592}, {'w', .818}, {'x', .592},
        {'y', .592}, {'z', .525}, {'A', .684}, {'W', .989}, {'M', .863}};
    const auto found = widths.find(c);
    return found == widths.end() ? 0.636 : found->second; // digits
}

struct Text {
    Rect box;
    std::string words;
};

// What is read: one letter for each that is written as `&name;`.
std::string without_entities(std::string words) {
    for (std::size_t at = words.find('&'); at != words.npos; at = words.find('&', at + 1))
        words.erase(at + 1, words.find(';', at) - at);
    return words;
}

// All texts of a picture, each with at least the space that its letters take.
std::vector<Text> texts(const std::string& svg) {
    std::vector<Text> all;
    for (const SvgElement& element : elements_of(svg)) {
        if (element.name != "text") continue;
        const std::string words = without_entities(element.words);
        const double x = element.number("x"), y = element.number("y"),
                     size = element.number("font-size");
        double width = 0;
        for (const char c : words)
            width += (c & 0x80) ? 0.5 * size : advance(c) * size; // an ellipsis has three bytes
        if (element.attributes.contains("font-weight")) width *= 1.09;
        const double left = element.is("text", "text-anchor", "end")      ? x - width
                            : element.is("text", "text-anchor", "middle") ? x - width / 2
                                                                          : x;
        all.push_back({{left, y - 0.73 * size, left + width, y + 0.2 * size}, words});
    }
    EXPECT_EQ(all.size(), count(svg, "<text"));
    return all;
}

void expect_readable(const std::string& svg) {
    const std::vector<SvgElement> elements = elements_of(svg);
    double x, y, width, height;
    ASSERT_TRUE(std::istringstream(elements.at(0)["viewBox"]) >> x >> y >> width >> height);
    EXPECT_TRUE(x == 0 && y == 0);
    const std::vector<Text> all = texts(svg);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Rect& box = all[k].box;
        EXPECT_TRUE(box.left >= 0 && box.right <= width && box.top >= 0 && box.bottom <= height)
            << all[k].words << " ends outside";
        for (std::size_t j = 0; j < k; ++j)
            EXPECT_FALSE(box.meets(all[j].box)) << all[j].words << " and " << all[k].words;
    }
    // 8 pixels at least where the picture is 800 wide.
    for (const SvgElement& element : elements)
        if (element.attributes.contains("font-size")) {
            EXPECT_GE(element.number("font-size") * 800 / width, 8);
        }
}

// x of each mark of an event: a sign has one, a path of ticks has many.
std::vector<double> marks_of_events(const std::string& svg) {
    std::vector<double> found;
    for (const SvgElement& element : elements_of(svg)) {
        if (!element.is("path", "class", "event") && !element.is("path", "class", "events"))
            continue;
        for (const PathStep& step : steps_of(element["d"]))
            if (step.letter == 'M') found.push_back(step.numbers.at(0));
    }
    std::ranges::sort(found);
    return found;
}

// Each event is marked once, where its time is.
void expect_marks(const std::string& svg, const TimelineRecord& record) {
    // The axis is the dark path along the picture.
    double left = 0, right = 0;
    for (const SvgElement& element : elements_of(svg)) {
        if (!element.is("path", "stroke", "#222")) continue;
        const std::vector<PathStep> steps = steps_of(element["d"]);
        if (steps.size() != 2 || steps[1].letter != 'H') continue;
        left = steps[0].numbers.at(0);
        right = steps[1].numbers.at(0);
    }
    ASSERT_LT(left, right);
    std::vector<double> wanted;
    for (const Event& event : record.timeline.events)
        wanted.push_back(left + (right - left) * mid(event.time) / 10); // they last 10 s
    std::ranges::sort(wanted);
    EXPECT_THAT(marks_of_events(svg), testing::Pointwise(testing::DoubleNear(0.006), wanted));
}

TEST(Plot, HasAMarkForEachEvent) {
    const TimelineRecord record = story();
    const std::string svg = plot_svg(record);
    expect_well_formed(svg);
    expect_readable(svg);
    expect_marks(svg, record);
    EXPECT_THAT(svg, HasSubstr("A &lt;made&gt; &amp; timed &quot;scene&quot;"));
    EXPECT_THAT(svg, HasSubstr("complete, all proved"));
    EXPECT_EQ(count(svg, "class=\"event\""), 4u);
    for (const char* label : {">components<", ">tunnels<", ">merge<", ">tunnel closes<", ">10.5<",
                              ">40.2<", ">90.7<", ">adds one<", ">takes one away<"}) {
        EXPECT_THAT(svg, HasSubstr(label));
    }
    for (const char* label :
         {">voids<", ">split<", ">unresolved<", ">not proved<", ">unknown<", ">one event<"}) {
        EXPECT_THAT(svg, Not(HasSubstr(label))) << "nothing of it happens";
    }
}

// From few to more than there are pixels: each event is marked, and no label is on another.
TEST(Plot, IsReadableHoweverManyEventsThereAre) {
    std::mt19937_64 random(17);
    std::size_t longest = 0;
    for (const int events : {1, 2, 3, 12, 40, 100, 400, 800, 2000}) {
        SCOPED_TRACE(events);
        TimelineRecord record = random_complete(random, events);
        record.header.title = std::string(std::size_t(events), 'W') + " of a long name";
        // Many at once, as symmetry has them.
        for (Event& event : record.timeline.events)
            if (event.time.lo > 6) event.time = near(7.123);
        std::vector<Thumbnail> thumbnails;
        for (const double frame : representative_frames(record, 8))
            thumbnails.push_back({frame, "a.png"});
        const std::string svg = plot_svg(record, thumbnails);
        expect_well_formed(svg);
        expect_readable(svg);
        expect_marks(svg, record);
        EXPECT_EQ(count(svg, "<image"), thumbnails.size());
        longest = std::max(longest, svg.size());
    }
    EXPECT_LT(longest, 200'000u) << "some ten bytes for a tick and for a step of a curve";
}

// The bars of a crowded lane count its events, and the number above the highest is what it counts.
TEST(Plot, BarsCountEvents) {
    std::vector<Event> events;
    for (int k = 0; k < 7; ++k) events.push_back(event_at(30.1 + 0.1 * k, Kind::birth));
    events.push_back(event_at(60.5, Kind::birth));
    events.push_back(event_at(80.5, Kind::birth));
    const std::string svg = plot_svg(complete({1, 0, 0}, events));
    std::vector<double> heights;
    for (const SvgElement& element : elements_of(svg)) {
        if (!element.is("path", "fill", "#009e73")) continue;
        std::string letters;
        const std::vector<PathStep> steps = steps_of(element["d"]);
        for (const PathStep& step : steps) letters += step.letter;
        if (!letters.starts_with("MhVhz")) continue; // a sign in the legend
        ASSERT_EQ(letters, "MhVhzMhVhzMhVhz");
        for (std::size_t k = 0; k < steps.size(); k += 5)
            heights.push_back(steps[k].numbers.at(1) - steps[k + 2].numbers.at(0));
    }
    ASSERT_EQ(heights.size(), 3u);
    EXPECT_NEAR(heights[0], 7 * heights[1], 0.5);
    EXPECT_NEAR(heights[1], heights[2], 1e-9);
    std::size_t sevens = 0;
    for (const Text& text : texts(svg)) sevens += text.words == "7";
    EXPECT_EQ(sevens, 1u);
    EXPECT_THAT(svg, HasSubstr(">events in a frame<"));
}

TEST(Plot, IsWellFormedWhateverIsKnown) {
    std::mt19937_64 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        TimelineRecord record = random_complete(random, int(random() % 40));
        expect_well_formed(plot_svg(record));
        const auto all = std::size_t(record.timeline.events.size());
        for (Event& event : record.timeline.events) {
            if (random() % 2) event.before.reset();
            if (random() % 2) event.after.reset();
            if (random() % 2) event.kind = Kind::unknown;
            if (random() % 5 == 0) event.kind = Kind::none;
            event.is_proved = random() % 2;
        }
        record.timeline.start.reset();
        record.timeline.unresolved.push_back({{-3, 4}, {}, "a <curve>", {}, {}});
        record.timeline.unresolved.push_back({formula::Interval::entire(), {}, "all", {}, {}});
        const std::string svg = plot_svg(record, {{12, "a&b.png"}, {1e9, "c.png"}});
        expect_well_formed(svg);
        expect_readable(svg);
        EXPECT_EQ(marks_of_events(svg).size(), all) << "those that change nothing, too";
        EXPECT_THAT(svg, HasSubstr(">unresolved<"));
        EXPECT_THAT(svg, HasSubstr("xlink:href=\"a&amp;b.png\""));
        EXPECT_EQ(count(svg, "incomplete, "), 1u);
    }
    TimelineRecord empty{ten_a_second(), {}};
    expect_well_formed(plot_svg(empty));
}

TEST(Telling, FramesAreInTheMiddleOfQuietSpans) {
    const TimelineRecord record = story();
    EXPECT_THAT(
        representative_frames(record, 5),
        testing::ElementsAre(testing::DoubleNear(5.75, 1e-6), // frames 1 to 10.5
                             testing::DoubleNear(15.375, 1e-6), testing::DoubleNear(30.225, 1e-6),
                             testing::DoubleNear(65.45, 1e-6), testing::DoubleNear(95.85, 1e-6)));
    const auto three = representative_frames(record, 3);
    ASSERT_EQ(three.size(), 3u);
    EXPECT_NEAR(three[1], 65.45, 1e-6) << "the tunnel is what differs longest";
    EXPECT_EQ(representative_frames(record, 0).size(), 0u);
    EXPECT_EQ(representative_frames(record, 1).size(), 1u);
}

TEST(Telling, FramesAscendWithinTheRangeAndAreNoEvents) {
    std::mt19937_64 random(6);
    for (int trial = 0; trial < 20; ++trial) {
        const TimelineRecord record = random_complete(random, int(random() % 300));
        const Steps steps = steps_of(record.timeline);
        const auto frames = representative_frames(record, 8);
        EXPECT_LE(frames.size(), 8u);
        EXPECT_TRUE(std::is_sorted(frames.begin(), frames.end()));
        for (const double frame : frames) EXPECT_TRUE(steps.at((frame - 1) / 10)) << frame;
    }
    TimelineRecord unknown{ten_a_second(), {}};
    unknown.timeline.range = {0, 10};
    EXPECT_EQ(representative_frames(unknown, 4).size(), 4u);
}

} // namespace
} // namespace isomotion::topology
