#include "topology/timeline/expectation.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/document.h"
#include "base/file_text.h"
#include "base/input_error.h"
#include "base/printable.h"
#include "topology/timeline/compare.h"
#include "topology/timeline/searched.h"
#include "topology/timeline/steps.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr std::size_t most_claim_bytes = 1 << 20;

struct NumberName {
    const char* name;
    int Betti::*number;
};
constexpr NumberName number_names[] = {
    {"components", &Betti::components}, {"tunnels", &Betti::tunnels}, {"voids", &Betti::voids}};

std::optional<double> decimal(std::string_view text) {
    if (text.empty() || text.front() == '.') return {}; // "5...9" has a dot too many
    double value = 0;
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, value, std::chars_format::fixed);
    if (error != std::errc{} || end != last || !std::isfinite(value)) return {};
    return value;
}

// A frame; infinite for an end of what was searched.
std::optional<double> parse_frame(std::string_view text) {
    if (text == "start") return -formula::infinity;
    if (text == "end") return formula::infinity;
    return decimal(text);
}

// "12", "40.5", "5..9", "end", "90..end".
std::optional<Interval> parse_frames(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == text.npos) {
        if (const auto frame = parse_frame(text)) return Interval(*frame, *frame);
        return {};
    }
    const auto from = parse_frame(text.substr(0, dots)), to = parse_frame(text.substr(dots + 2));
    if (!from || !to || *from > *to) return {};
    return Interval{*from, *to};
}

void read_betti(const base::DocumentNode& node, const NumberName& which,
                std::vector<BettiClaim>& claims) {
    base::DocumentTable frames = node.table();
    std::vector<base::DocumentNode> all = frames.all();
    std::ranges::sort(all, {}, &base::DocumentNode::key); // as of TOML
    for (const base::DocumentNode& each : all) {
        const std::string key = frames.key_of(each);
        const auto when = parse_frames(key);
        if (!when) {
            each.fail(
                fmt::format("'{}' is no frame; write \"12\", \"40.5\", \"5..9\" or \"end\"", key));
        }
        if (each.is_table()) {
            each.fail("TOML takes the dots for tables of tables; put the frame in quotes: "
                      "\"40.5\" = 2");
        }
        claims.push_back({each.key(), which.number, *when, each.integer(0, 1'000'000'000)});
    }
}

Claims read_claims(const base::Document& document, const std::string& file,
                   animation::FrameRate fps) {
    base::DocumentTable root = document.table();
    Claims claims;
    std::optional<double> tolerance;
    if (const auto node = root.find("tolerance")) {
        tolerance = node->number();
        if (*tolerance < 0) node->fail("must be a number of frames, 0 or more");
    }
    for (const NumberName& which : number_names) {
        if (const auto node = root.find(which.name)) read_betti(*node, which, claims.betti);
    }
    if (const auto events = root.find("events")) {
        for (const base::DocumentNode& each : events->list()) {
            try {
                claims.events.push_back(parse_statement(each.text(), fps, tolerance));
            } catch (const std::invalid_argument& error) {
                each.fail(fmt::format("\"{}\": {}", each.text(), error.what()));
            }
        }
    }
    root.refuse_rest();
    if (claims.betti.empty() && claims.events.empty()) {
        throw base::InputError(
            fmt::format("{}: claims nothing; write {{ \"components\": {{ \"1\": 2 "
                        "}}, \"events\": [\"merge at frame 12..13\"] }}",
                        file));
    }
    return claims;
}

// Whether all that happens in the instant is known, and none of it changes the number: then it is
// the same all the time, in whatever order things happen.
bool keeps(const Timeline& timeline, const Instant& instant, int Betti::*number) {
    return instant.unresolved.empty() &&
           std::ranges::all_of(instant.events, [&](const std::size_t k) {
               const Event& event = timeline.events[k];
               return event.is_proved && event.kind != Kind::unknown &&
                      change(event.kind).*number == 0;
           });
}

// Judges a claim at one frame, or at all of a span: each step that lasts in it has to say the
// number, and no instant in it may change that.
Judgement judge(const BettiClaim& claim, const TimelineRecord& found, const Steps& steps) {
    const auto fps = found.header.fps;
    const Timeline& timeline = found.timeline;
    if (std::string missing = unsearched(claim.frames, timeline.range, fps); !missing.empty()) {
        return {Truth::open, std::move(missing)};
    }
    const Interval searched{frame_at(fps, timeline.range.lo), frame_at(fps, timeline.range.hi)};
    const auto bound = [&](double frame) {
        return std::isfinite(frame) ? frame : frame < 0 ? searched.lo : searched.hi;
    };
    const Interval frames{bound(claim.frames.lo), bound(claim.frames.hi)};
    constexpr double slack = 1e-6;
    // An event at the very end of a span is not in it, however its time was rounded.
    const Interval asked =
        frames.hi - frames.lo > 2 * slack ? Interval{frames.lo + slack, frames.hi - slack} : frames;
    const auto touches = [&](Interval time) {
        const Interval frames = frames_at(fps, time);
        return frames.lo <= asked.hi && asked.lo <= frames.hi;
    };
    const bool is_moment = is_point(asked);
    // A step that is over as it begins says nothing about a span.
    const auto lasts_in = [&](Interval time) {
        const Interval frames = frames_at(fps, time);
        return touches(time) &&
               (is_moment || std::min(frames.hi, asked.hi) > std::max(frames.lo, asked.lo));
    };
    Judgement judgement{Truth::holds, ""};
    const auto open = [&](std::string why) {
        if (judgement.truth == Truth::holds) judgement = {Truth::open, std::move(why)};
    };
    for (const Instant& instant : steps.instants) {
        if (!touches(instant.time)) continue;
        if (is_moment) {
            return {Truth::open, "that is the instant of an event; ask a little before or "
                                 "after it"};
        }
        if (keeps(timeline, instant, claim.number)) continue;
        open(fmt::format("what the number is all through frame {} is not known",
                         frame_text(frames_at(fps, instant.time))));
    }
    bool is_seen = false;
    for (const Step& step : steps.steps) {
        if (!lasts_in(step.time)) continue;
        is_seen = true;
        const std::string frame = frame_text(std::max(frames.lo, frame_at(fps, step.time.lo)));
        if (!step.solid) {
            open(fmt::format("not known from frame {} on", frame));
            continue;
        }
        const int number = (*step.solid).*claim.number;
        if (number == claim.value && step.is_proved) continue;
        if (number == claim.value) {
            open(fmt::format("found, but not proved from frame {} on", frame));
        } else if (step.is_proved) {
            return {Truth::fails, fmt::format("{} at frame {}", number, frame)};
        } else {
            open(fmt::format("{} at frame {}, but not proved", number, frame));
        }
    }
    if (!is_seen) open("no time between events is among the frames asked for");
    return judgement;
}

} // namespace

Claims parse_claims(std::string_view text, const std::string& file, animation::FrameRate fps) {
    const bool is_toml = file.ends_with(".toml");
    return read_claims(is_toml ? base::Document::from_toml(text, file)
                               : base::Document::from_json(text, file),
                       file, fps);
}

Expectation read_expectation(const std::filesystem::path& file, animation::FrameRate fps) {
    const std::string text = base::file_text(file, most_timeline_bytes);
    if (file.extension() != ".toml") {
        const auto document = base::Document::from_json(text, file.string());
        if (document.table().find("format")) return parse_timeline(text, file.string());
    }
    if (text.size() > most_claim_bytes) {
        throw base::InputError(
            fmt::format("{}: claims of more than {} bytes, the most that are read",
                        base::printable_line(file.string()), most_claim_bytes));
    }
    return parse_claims(text, file.string(), fps);
}

Check check(const Claims& claims, const TimelineRecord& found) {
    Check result;
    const auto add = [&](const std::string& claim, const Judgement& judgement) {
        switch (judgement.truth) {
        case Truth::holds:
            ++result.agreed;
            return;
        case Truth::fails:
            result.differences.push_back(fmt::format("{}: {}", claim, judgement.why));
            return;
        case Truth::open:
            result.undecided.push_back(fmt::format("{}: {}", claim, judgement.why));
            return;
        }
    };
    const Steps steps = steps_of(found.timeline);
    for (const BettiClaim& claim : claims.betti) {
        add(fmt::format("{} = {}", claim.key, claim.value), judge(claim, found, steps));
    }
    for (std::size_t k = 0; k < claims.events.size(); ++k) {
        const Statement& statement = claims.events[k];
        add(fmt::format("events[{}] \"{}\"", k, statement.text),
            judge(statement, claims.events, found.timeline, found.header.fps));
    }
    if (result.outcome() != Outcome::passes) {
        for (const std::string& reason : gaps(found.timeline, found.header.fps)) {
            result.notes.push_back("found: " + reason);
        }
    }
    return result;
}

Check check(const Expectation& expectation, const TimelineRecord& found, double dt) {
    if (const auto* record = std::get_if<TimelineRecord>(&expectation))
        return compare(*record, found, dt);
    return check(std::get<Claims>(expectation), found);
}

std::string text(const Check& check, const std::string& path) {
    const std::string file = base::printable_line(path);
    std::string lines;
    const auto add = [&](const char* what, const std::string& line) {
        lines += what + base::printable_line(line) + "\n"; // it may hold words of the expectation
    };
    for (const std::string& line : check.differences) add("", line);
    for (const std::string& line : check.undecided) add("undecided: ", line);
    for (const std::string& line : check.notes) add("note: ", line);
    const std::size_t different = check.differences.size(), open = check.undecided.size();
    switch (check.outcome()) {
    case Outcome::passes:
        return lines + fmt::format("{}: passes, {} agree\n", file, check.agreed);
    case Outcome::differs:
        return lines + fmt::format("{}: differs, {} difference{}, {} undecided, {} agree\n", file,
                                   different, different == 1 ? "" : "s", open, check.agreed);
    case Outcome::incomplete:
        break;
    }
    return lines +
           fmt::format("{}: INCOMPLETE, neither passed nor failed: {} undecided, {} agree\n", file,
                       open, check.agreed);
}

} // namespace isomotion::topology
