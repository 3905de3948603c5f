#include "topology/timeline/timeline_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/document.h"
#include "base/file_text.h"
#include "base/input_error.h"
#include "base/printable.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;
using Json = nlohmann::ordered_json; // keys as they were added
using Point = std::array<Interval, 3>;

constexpr std::string_view shape_names[] = {"box", "sphere"}; // by scene::Bounds::Shape

Json json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json json(Interval interval) { return Json::array({json(interval.lo), json(interval.hi)}); }
Json json(const Point& box) { return Json::array({json(box[0]), json(box[1]), json(box[2])}); }
Json json(const Betti& betti) {
    return Json::array({betti.components, betti.tunnels, betti.voids});
}

Json topology(const std::optional<Betti>& solid) {
    if (!solid) return nullptr;
    return {{"solid", json(*solid)}, {"surface", json(surface_of(*solid))}};
}

Json point(const Point& where) {
    return Json::array({mid(where[0]), mid(where[1]), mid(where[2])});
}

// The radius of a ball about point(where) that holds the box.
double radius(const Point& where) {
    double sum = 0;
    for (const Interval side : where) {
        const double middle = mid(side);
        sum += std::pow(std::max(side.hi - middle, middle - side.lo), 2);
    }
    return std::sqrt(sum) * (1 + 0x1p-50); // rounding of three squares and a root
}

Json json(const Event& event, animation::FrameRate fps) {
    return {{"frame", frame_at(fps, mid(event.time))},
            {"kind", name(event.kind)},
            {"time", json(event.time)},
            {"point", point(event.where)},
            {"radius", json(radius(event.where))},
            {"where", json(event.where)},
            {"stratum", event.stratum},
            {"index", event.index},
            {"direction", event.grows ? "grows" : "shrinks"},
            {"proved", event.is_proved},
            {"proved_again", event.is_proved_again},
            {"kind_proof", event.kind_proof},
            {"before", topology(event.before)},
            {"after", topology(event.after)}};
}

Json json(const Unresolved& place, animation::FrameRate fps) {
    return {{"frame", frame_at(fps, mid(place.time))},
            {"why", place.why},
            {"time", json(place.time)},
            {"where", json(place.where)},
            {"before", topology(place.before)},
            {"after", topology(place.after)}};
}

// One item a line, so that differences of two files are differences of lines.
template<class Items, class Convert> std::string lines(const Items& items, Convert&& convert) {
    std::string text;
    for (const auto& item : items) {
        text += fmt::format("{}\n    {}", text.empty() ? "" : ",", convert(item).dump());
    }
    return text.empty() ? "[]" : fmt::format("[{}\n  ]", text);
}

// A derived number as it was written, or near: another program may have rounded it otherwise.
bool is_near(double written, double derived) {
    return std::abs(written - derived) <= 1e-6 * std::max(1.0, std::abs(derived));
}

// Programs print what timelines say: none of it may move the cursor or begin a line.
std::string line_of(const base::DocumentNode& node) {
    std::string text = node.text();
    constexpr std::size_t most = 4096;
    if (text.size() > most || !base::is_one_printable_line(text))
        node.fail(fmt::format("must be one printable line of at most {} bytes", most));
    return text;
}

// [lo, hi], null in place of an end for none on that side; a number for a point.
Interval interval_of(const base::DocumentNode& node) {
    if (node.is_number()) return node.number();
    const auto ends = node.is_list() ? node.list() : std::vector<base::DocumentNode>();
    if (ends.size() != 2) node.fail("must be [lo, hi], null in place of an end that there is not");
    const Interval interval{ends[0].is_null() ? -formula::infinity : ends[0].number(),
                            ends[1].is_null() ? formula::infinity : ends[1].number()};
    if (is_empty(interval)) node.fail("must be [lo, hi] with lo not above hi");
    return interval;
}

Betti read_betti(const base::DocumentNode& node) {
    const auto numbers = node.list(3);
    const auto count = [](const base::DocumentNode& number) {
        return number.integer(0, 1'000'000'000);
    };
    return {count(numbers[0]), count(numbers[1]), count(numbers[2])};
}

// The solid's numbers. Those of the surface follow from them, and are checked if they are there.
Betti read_solid(base::DocumentTable& object) {
    const base::DocumentNode numbers = object.at("solid");
    const Betti solid = read_betti(numbers);
    if (!solid.is_possible())
        numbers.fail("cannot be: without a component there is no tunnel and no void");
    if (const auto surface = object.find("surface")) {
        const Betti follows = surface_of(solid);
        if (read_betti(*surface) != follows) {
            surface->fail(
                fmt::format("contradicts the solid's; its surface has {}", json(follows).dump()));
        }
    }
    return solid;
}

std::optional<Betti> read_topology(const base::DocumentNode& node) {
    if (node.is_null()) return std::nullopt;
    base::DocumentTable object = node.table();
    const Betti solid = read_solid(object);
    object.refuse_rest();
    return solid;
}

Point read_box(const base::DocumentNode& node) {
    const auto sides = node.list(3);
    return {interval_of(sides[0]), interval_of(sides[1]), interval_of(sides[2])};
}

void check_frame(base::DocumentTable& object, Interval time, animation::FrameRate fps) {
    const auto frame = object.find("frame");
    if (!frame) return;
    const double follows = frame_at(fps, mid(time));
    if (!is_near(frame->number(), follows)) {
        frame->fail(fmt::format("contradicts 'time', which is at frame {:.10g}; change both or "
                                "leave out 'frame'",
                                follows));
    }
}

void check_point(base::DocumentTable& object, const Point& where) {
    if (const auto written = object.find("point")) {
        const auto numbers = written->list(3);
        for (std::size_t k = 0; k < 3; ++k) {
            if (!is_near(numbers[k].number(), mid(where[k]))) {
                numbers[k].fail(fmt::format("contradicts 'where', whose middle is {:.10g}; change "
                                            "both or leave out 'point'",
                                            mid(where[k])));
            }
        }
    }
    if (const auto written = object.find("radius")) {
        const double follows = radius(where);
        const bool agrees =
            std::isfinite(follows)
                ? !written->is_null() && std::abs(written->number() - follows) <= 1e-6 * follows
                : written->is_null();
        if (!agrees) {
            written->fail(
                std::isfinite(follows)
                    ? fmt::format("contradicts 'where', which is in a ball of {:.10g}", follows)
                    : "contradicts 'where', which is in no ball; write null");
        }
    }
}

Event read_event(const base::DocumentNode& node, animation::FrameRate fps) {
    base::DocumentTable object = node.table();
    Event event;
    event.time = interval_of(object.at("time"));
    check_frame(object, event.time, fps);
    event.where = read_box(object.at("where"));
    check_point(object, event.where);
    event.stratum = object.at("stratum").integer(0, 3);
    event.index = object.at("index").integer(0, event.stratum);
    const base::DocumentNode direction = object.at("direction");
    if (direction.text() != "grows" && direction.text() != "shrinks") {
        direction.fail("must be \"grows\" or \"shrinks\"");
    }
    event.grows = direction.text() == "grows";
    const base::DocumentNode kind = object.at("kind");
    const auto known = parse_kind(kind.text());
    if (!known) {
        std::vector<std::string_view> names;
        for (int k = 0; k <= int(Kind::none); ++k) names.push_back(name(Kind(k)));
        kind.fail(
            fmt::format("there is no kind '{}'; known: {}", kind.text(), fmt::join(names, ", ")));
    }
    event.kind = *known;
    event.is_proved = object.at("proved").boolean();
    if (const auto again = object.find("proved_again")) event.is_proved_again = again->boolean();
    event.kind_proof = line_of(object.at("kind_proof"));
    event.before = read_topology(object.at("before"));
    event.after = read_topology(object.at("after"));
    object.refuse_rest();
    return event;
}

Unresolved read_unresolved(const base::DocumentNode& node, animation::FrameRate fps) {
    base::DocumentTable object = node.table();
    Unresolved place;
    place.time = interval_of(object.at("time"));
    check_frame(object, place.time, fps);
    place.where = read_box(object.at("where"));
    place.why = line_of(object.at("why"));
    place.before = read_topology(object.at("before"));
    place.after = read_topology(object.at("after"));
    object.refuse_rest();
    return place;
}

// An item that certainly comes before an earlier one of its list is out of order.
template<class Item, class Read>
std::vector<Item> read_ordered(const base::DocumentNode& node, Read&& read) {
    std::vector<Item> items;
    double latest = -formula::infinity;
    for (const base::DocumentNode& each : node.list()) {
        items.push_back(read(each));
        if (items.back().time.hi < latest) {
            each.fail("comes before one above it; sort by time");
        }
        latest = std::max(latest, items.back().time.lo);
    }
    return items;
}

void read_format(base::DocumentTable& root) {
    const base::DocumentNode format = root.at("format");
    if (format.text() != timeline_format) {
        format.fail(fmt::format("is '{}'; a timeline's is '{}'", format.text(), timeline_format));
    }
    const base::DocumentNode version = root.at("version");
    if (const int found = version.integer(1, INT32_MAX); found != timeline_version) {
        version.fail(fmt::format("is {}, which this program cannot read; it reads {}: write the "
                                 "file anew with isomotion topology",
                                 found, timeline_version));
    }
}

std::vector<int> read_solids(const base::DocumentNode& node) {
    const auto sign = [](const base::DocumentNode& one) {
        const std::string text = one.text();
        if (text != solid_text(-1) && text != solid_text(1))
            one.fail("must be \"F < 0\" or \"F > 0\", the side that is the solid");
        return text == solid_text(1) ? 1 : -1;
    };
    if (!node.is_list()) return {sign(node)};
    const auto both = node.list(2);
    return {sign(both[0]), sign(both[1])};
}

TimelineHeader read_header(base::DocumentTable& root) {
    TimelineHeader header;
    base::DocumentTable scene = root.at("scene").table();
    header.title = line_of(scene.at("title"));
    header.fingerprint = line_of(scene.at("fingerprint"));
    scene.refuse_rest();
    const base::DocumentNode rate = root.at("frames_per_second");
    const auto fps = animation::parse_frame_rate(rate.text());
    if (!fps) rate.fail("must be a rate above 0: \"30\", \"30000/1001\"");
    header.fps = *fps;
    base::DocumentTable bounds = root.at("bounds").table();
    const base::DocumentNode shape = bounds.at("shape");
    const auto known = std::ranges::find(shape_names, shape.text());
    if (known == std::end(shape_names)) shape.fail("must be \"box\" or \"sphere\"");
    header.shape = scene::Bounds::Shape(known - std::begin(shape_names));
    header.start_bounds = read_box(bounds.at("start"));
    header.end_bounds = read_box(bounds.at("end"));
    bounds.refuse_rest();
    if (const auto solid = root.find("solid")) header.solids = read_solids(*solid);
    return header;
}

// One end of the range.
void read_end(const base::DocumentNode& node, std::optional<Betti>& solid, bool& is_proved) {
    if (node.is_null()) return;
    base::DocumentTable object = node.table();
    solid = read_solid(object);
    is_proved = object.at("proved").boolean();
    object.refuse_rest();
}

Json json_of_end(const std::optional<Betti>& solid, bool is_proved) {
    Json end = topology(solid);
    if (solid) end["proved"] = is_proved;
    return end;
}

} // namespace

std::string to_json(const TimelineRecord& record) {
    const TimelineHeader& header = record.header;
    const Timeline& timeline = record.timeline;
    const auto fps = header.fps;
    const Json scene{{"title", header.title}, {"fingerprint", header.fingerprint}};
    const Json bounds{{"shape", shape_names[std::size_t(header.shape)]},
                      {"start", json(header.start_bounds)},
                      {"end", json(header.end_bounds)}};
    const Json frames =
        Json::array({frame_at(fps, timeline.range.lo), frame_at(fps, timeline.range.hi)});
    std::string text = "{";
    const auto add = [&](const char* key, const std::string& value) {
        text += fmt::format("{}\n  \"{}\": {}", text.size() > 1 ? "," : "", key, value);
    };
    add("format", Json(timeline_format).dump());
    add("version", Json(timeline_version).dump());
    add("scene", scene.dump());
    add("frames_per_second", Json(animation::to_string(fps)).dump());
    add("bounds", bounds.dump());
    if (header.solids.size() == 1) add("solid", Json(solid_text(header.solids[0])).dump());
    if (header.solids.size() == 2) {
        add("solid",
            Json::array({solid_text(header.solids[0]), solid_text(header.solids[1])}).dump());
    }
    add("time", json(timeline.range).dump());
    add("frames", frames.dump());
    add("complete", Json(timeline.is_complete()).dump());
    add("none_missing", Json(timeline.is_proved).dump());
    add("doubts", lines(timeline.doubts, [](const std::string& doubt) { return Json(doubt); }));
    add("start", json_of_end(timeline.start, timeline.start_is_proved).dump());
    add("end", json_of_end(timeline.end, timeline.end_is_proved).dump());
    add("events", lines(timeline.events, [&](const Event& event) { return json(event, fps); }));
    add("unresolved",
        lines(timeline.unresolved, [&](const Unresolved& place) { return json(place, fps); }));
    return text + "\n}\n";
}

TimelineRecord parse_timeline(std::string_view text, const std::string& file) {
    const auto document = base::Document::from_json(text, file);
    base::DocumentTable root = document.table();
    read_format(root);
    TimelineRecord record{read_header(root), {}};
    Timeline& timeline = record.timeline;
    const auto fps = record.header.fps;
    const base::DocumentNode time = root.at("time");
    timeline.range = interval_of(time);
    if (!std::isfinite(timeline.range.lo) || !std::isfinite(timeline.range.hi)) {
        time.fail("must be [first, last] in seconds, both finite");
    }
    if (const auto frames = root.find("frames")) {
        const auto ends = frames->list(2);
        const double lo = frame_at(fps, timeline.range.lo), hi = frame_at(fps, timeline.range.hi);
        if (!is_near(ends[0].number(), lo) || !is_near(ends[1].number(), hi)) {
            frames->fail(fmt::format("contradicts 'time', which is frames {:.10g} to {:.10g}; "
                                     "change both or leave out 'frames'",
                                     lo, hi));
        }
    }
    timeline.is_proved = root.at("none_missing").boolean();
    for (const base::DocumentNode& doubt : root.at("doubts").list())
        timeline.doubts.push_back(line_of(doubt));
    read_end(root.at("start"), timeline.start, timeline.start_is_proved);
    read_end(root.at("end"), timeline.end, timeline.end_is_proved);
    timeline.events = read_ordered<Event>(
        root.at("events"), [&](const base::DocumentNode& node) { return read_event(node, fps); });
    timeline.unresolved =
        read_ordered<Unresolved>(root.at("unresolved"), [&](const base::DocumentNode& node) {
            return read_unresolved(node, fps);
        });
    if (const auto complete = root.find("complete")) {
        if (complete->boolean() != timeline.is_complete()) {
            complete->fail(fmt::format("contradicts the rest of the file, by which it is {}",
                                       timeline.is_complete()));
        }
    }
    root.refuse_rest();
    return record;
}

TimelineRecord read_timeline(const std::filesystem::path& file) {
    return parse_timeline(base::file_text(file, most_timeline_bytes), file.string());
}

} // namespace isomotion::topology
