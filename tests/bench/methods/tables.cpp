#include "methods/tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace isomotion::bench {
namespace {

double mega_rays_a_second(const Contest& contest, const Standing& standing) {
    const double rays = double(standing.count.errors.rays) / contest.frames;
    return rays / standing.timing.ms / 1e3;
}

std::string in_quotes(const std::string& text) {
    std::string safe = "\"";
    for (const char c : text) safe += c == '"' ? "\"\"" : c == '\n' ? " " : std::string(1, c);
    return safe + "\"";
}

// A cell of Markdown: one line, no bar.
std::string cell(const std::string& text) {
    const std::string line = text.substr(0, std::min(text.find('\n'), std::size_t(100)));
    std::string safe;
    for (const char c : line) safe += c == '|' ? std::string("\\|") : std::string(1, c);
    return safe;
}

// "2.31 (1/8)": faster than the sign test with an eighth of its step.
std::string equal(const Standing& s) {
    return fmt::format("{}{:.2f} ({}{})", s.reached ? "" : ">= ", s.against_equal,
                       s.halvings ? "1/" : "", 1 << s.halvings);
}

std::string contest_rows(const Results& results, const Contest& contest) {
    std::string text;
    for (const Standing& s : contest.standings) {
        text += fmt::format("| {} | {} |", contest.subject, scene::name(s.method));
        if (!s.refused.empty()) {
            text += fmt::format(" no: {} | | | | | | | | | | | |\n", cell(s.refused));
            continue;
        }
        const accuracy::Errors& e = s.count.errors;
        text +=
            fmt::format(" {:.2f} | {:.0f}% | {:.2f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | "
                        "{:.2f} | {} | {:.2f} | {:.1f}% |\n",
                        s.timing.ms, 100 * s.timing.spread, mega_rays_a_second(contest, s),
                        s.count.evaluations_a_ray(), e.wrong_ppm(), s.count.ppm(e.missed),
                        s.count.ppm(e.false_hits), s.count.ppm(e.wrong_roots), s.against_own,
                        equal(s), s.at_most, 100 * s.operations / results.peak);
    }
    return text;
}

constexpr const char* contest_head =
    "| subject | method | ms | +- | Mray/s | evaluations a ray | wrong ppm | missed | false | "
    "behind | against amp-sign, same step | at equal accuracy | "
    "at most | of the peak |\n"
    "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";

// Ratios of one method over all contests that it did not refuse.
struct Ratios {
    double logarithms = 0, least = INFINITY;
    std::string worst;
    int count = 0, bounds = 0;

    void add(const std::string& subject, double ratio, bool exact) {
        logarithms += std::log(ratio);
        if (ratio < least) std::tie(least, worst) = std::pair(ratio, subject);
        ++count;
        bounds += !exact;
    }
    double mean() const { return std::exp(logarithms / count); }
};

std::string summary(const std::vector<Contest>& contests) {
    std::string text = "| method | surfaces | none wrong | wrong ppm, mean | same step: mean | "
                       "worst | equal accuracy: mean | worst | at most | still less right "
                       "|\n"
                       "|---|--:|--:|--:|--:|---|--:|---|--:|--:|\n";
    for (std::size_t k = 0; k < contests.front().standings.size(); ++k) {
        Ratios own, equally, most;
        int right = 0;
        double wrong = 0;
        for (const Contest& contest : contests) {
            const Standing& s = contest.standings[k];
            if (!s.refused.empty()) continue;
            own.add(contest.subject, s.against_own, true);
            equally.add(contest.subject, s.against_equal, s.reached);
            most.add(contest.subject, s.at_most, s.reached);
            right += s.count.errors.wrong() == 0;
            wrong += s.count.errors.wrong_ppm();
        }
        text += fmt::format("| {} | {} |", scene::name(contests.front().standings[k].method),
                            own.count);
        text += own.count == 0
                    ? " | | | | | | | |\n"
                    : fmt::format(" {} | {:.1f} | {:.2f} | {:.2f} {} | {}{:.2f} | {:.2f} {} | "
                                  "{:.2f} | {} |\n",
                                  right, wrong / own.count, own.mean(), own.least, own.worst,
                                  equally.bounds ? ">= " : "", equally.mean(), equally.least,
                                  equally.worst, most.mean(), equally.bounds);
    }
    return text;
}

// A line for each size or count, a column for each method.
std::string growth_table(const std::vector<Growth>& growth, const std::string& kind) {
    std::vector<scene::Method> methods;
    std::vector<std::tuple<std::string, int, int>> lines; // subject, at, size
    std::map<std::tuple<std::string, int, scene::Method>, std::string> cells;
    for (const Growth& g : growth) {
        if (g.kind != kind) continue;
        if (std::find(methods.begin(), methods.end(), g.method) == methods.end()) {
            methods.push_back(g.method);
        }
        const std::tuple line(g.subject, g.at, g.size);
        if (lines.empty() || lines.back() != line) lines.push_back(line);
        cells[{g.subject, g.at, g.method}] =
            g.timing.refused.empty()
                ? fmt::format("{:.0f} ({:.1f})", g.ns_a_ray(), g.evaluations_a_ray())
                : "no: " + cell(g.timing.refused);
    }
    if (lines.empty()) return "";
    std::string text = fmt::format(
        "\n## Cost against {0}\n\nns a ray (evaluations a ray), each at its scene's own step.\n\n"
        "| subject | {0} |",
        kind);
    for (const auto method : methods) text += fmt::format(" {} |", scene::name(method));
    text += "\n|---|--:|";
    for (std::size_t k = 0; k < methods.size(); ++k) text += "--:|";
    text += "\n";
    for (const auto& [subject, at, size] : lines) {
        text += fmt::format("| {}{} | {} |", subject,
                            size == at ? "" : fmt::format(", {0}x{0}", size), at);
        for (const auto method : methods) text += " " + cells[{subject, at, method}] + " |";
        text += "\n";
    }
    return text;
}

std::string coherence_table(const std::vector<Coherence>& all) {
    if (all.empty()) return "";
    std::string text = fmt::format(
        "\n## Coherence from frame to frame, {0}x{0}\n\n"
        "`hermite`, by what a frame is told of where its rays begin. Nothing is proved of what it "
        "is\ntold: that would take time beside this, so gains are more than a sound scheme can "
        "have.\n\n"
        "| subject | frames | known | ms | +- | gain | evaluations a ray | wrong ppm |\n"
        "|---|--:|---|--:|--:|--:|--:|--:|\n",
        all.front().size);
    for (const Coherence& subject : all) {
        for (const Carried& row : subject.rows) {
            text += fmt::format("| {} | {} | {} | {:.2f} | {:.0f}% | {:.2f} | {:.1f} | {:.1f} |\n",
                                subject.subject, subject.frames, name(row.known), row.timing.ms,
                                100 * row.timing.spread, row.gain, row.count.evaluations_a_ray(),
                                row.count.errors.wrong_ppm());
        }
    }
    return text;
}

} // namespace

std::string contests_csv(const Results& results) {
    std::string text =
        "kind,subject,method,size,frames,step,ms,spread,mrays_per_s,evaluations_per_ray,wrong_ppm,"
        "missed_ppm,false_hit_ppm,wrong_root_ppm,undecided_ppm,against_amp_sign_same_step,"
        "equal_step_divisor,equal_reached,against_amp_sign_equal_accuracy,at_most,empty_ms,"
        "field_gflops,peak_gflops,refused,machine,date\n";
    for (const auto& [kind, contests] :
         {std::pair{"surface", &results.surfaces}, {"animation", &results.animations}}) {
        for (const Contest& contest : *contests) {
            for (const Standing& s : contest.standings) {
                const accuracy::Errors& e = s.count.errors;
                text +=
                    fmt::format("{},{},{},{},{},{:g},", kind, contest.subject,
                                scene::name(s.method), contest.size, contest.frames, contest.step);
                text += !s.refused.empty()
                            ? std::string(16, ',')
                            : fmt::format(
                                  "{:.4f},{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},"
                                  "{:.4f},{},{},{:.4f},{:.4f},{:.4f},{:.4f},",
                                  s.timing.ms, s.timing.spread, mega_rays_a_second(contest, s),
                                  s.count.evaluations_a_ray(), e.wrong_ppm(), s.count.ppm(e.missed),
                                  s.count.ppm(e.false_hits), s.count.ppm(e.wrong_roots),
                                  s.count.ppm(e.undecided), s.against_own, 1 << s.halvings,
                                  int(s.reached), s.against_equal, s.at_most, contest.empty.ms,
                                  1e-9 * s.operations);
                text += fmt::format("{:.3f},{},{},{}\n", 1e-9 * results.peak, in_quotes(s.refused),
                                    in_quotes(results.machine), results.date);
            }
        }
    }
    return text;
}

std::string growth_csv(const Results& results) {
    std::string text = "kind,subject,method,size,at,ms,spread,rays,ns_per_ray,evaluations_per_ray,"
                       "ns_per_ray_at_peak,refused,machine,date\n";
    for (const Growth& g : results.growth) {
        text +=
            fmt::format("{},{},{},{},{},", g.kind, g.subject, scene::name(g.method), g.size, g.at);
        text += !g.timing.refused.empty()
                    ? std::string(6, ',')
                    : fmt::format("{:.4f},{:.4f},{},{:.3f},{:.3f},{:.3f},", g.timing.ms,
                                  g.timing.spread, g.rays, g.ns_a_ray(), g.evaluations_a_ray(),
                                  g.least_ns_a_ray(results.peak));
        text += fmt::format("{},{},{}\n", in_quotes(g.timing.refused), in_quotes(results.machine),
                            results.date);
    }
    return text;
}

std::string coherence_csv(const Results& results) {
    std::string text = "subject,size,frames,known,ms,spread,gain,evaluations_per_ray,wrong_ppm,"
                       "machine,date\n";
    for (const Coherence& subject : results.coherence) {
        for (const Carried& row : subject.rows) {
            text += fmt::format(
                "{},{},{},{},{:.4f},{:.4f},{:.4f},{:.3f},{:.3f},{},{}\n", subject.subject,
                subject.size, subject.frames, in_quotes(name(row.known)), row.timing.ms,
                row.timing.spread, row.gain, row.count.evaluations_a_ray(),
                row.count.errors.wrong_ppm(), in_quotes(results.machine), results.date);
        }
    }
    return text;
}

std::string markdown(const Results& results) {
    std::string text = fmt::format(
        "# Methods against each other\n\n"
        "{}, {}. Medians of up to {} frames, methods drawn in turn; peak of multiply-adds in a\n"
        "fragment shader {:.1f} Gflop/s. Made by `build/release/tests/bench/methods`.\n\n"
        "A ray is one that meets the bounds. Ratios are the time of the adaptive sign test\n"
        "(amp-sign) over the method's: above 1 the method is faster. *Same step*: both at the\n"
        "scene's, the paper's where it tells one. *Equal accuracy*: the sign test's step is "
        "halved\n"
        "until no more pixels are certainly wrong than the method's; in brackets the part of the\n"
        "step that takes. `>=`: at 1/{} of the step more are wrong still. *At most*: the same "
        "time\n"
        "over that of a frame without a ray to march, which no method can pass here, found it\n"
        "roots for nothing. *Of the peak*:\n"
        "operations of the field (a division or a function counts as one) times evaluations.\n",
        results.machine, results.date, results.repeat, 1e-9 * results.peak,
        1 << results.most_halvings);
    const auto section = [&](const std::string& title, const std::vector<Contest>& contests,
                             bool with_summary) {
        if (contests.empty()) return;
        text +=
            fmt::format("\n## {}, {}x{}\n\n", title, contests.front().size, contests.front().size);
        if (with_summary) {
            text += "Means of ratios are geometric; the last column counts the surfaces on which "
                    "the\nsign test stays less right than the method.\n\n" +
                    summary(contests) + "\n";
        }
        text += contest_head;
        for (const Contest& contest : contests) text += contest_rows(results, contest);
    };
    section("Surfaces of Table I", results.surfaces, true);
    if (!results.animations.empty()) {
        section(fmt::format("Animation, mean of {} frames", results.animations.front().frames),
                results.animations, false);
    }
    return text + coherence_table(results.coherence) + growth_table(results.growth, "resolution") +
           growth_table(results.growth, "blobs") + growth_table(results.growth, "degree") +
           growth_table(results.growth, "lights");
}

} // namespace isomotion::bench
