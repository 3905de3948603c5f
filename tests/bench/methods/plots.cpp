#include "methods/plots.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <set>

#include <fmt/format.h>

namespace isomotion::bench {
namespace {

// Told apart by shape too; dark to light, and in every kind of colour blindness (Okabe & Ito).
constexpr const char* colours[] = {"#000000", "#0072b2", "#d55e00", "#009e73",
                                   "#cc79a7", "#e69f00", "#56b4e9", "#8c6d31"};
constexpr int marks[] = {7, 5, 9, 11, 13, 4, 6, 8};

std::string style(std::size_t k) {
    return fmt::format("pt {} ps 0.6 lc rgb '{}'", marks[k % std::size(marks)],
                       colours[k % std::size(colours)]);
}

// In a string of gnuplot's a quote is doubled; an underscore is no index there (noenhanced).
std::string in_quotes(const std::string& text) {
    std::string safe = "'";
    for (const char c : text) safe += c == '\'' ? "''" : std::string(1, c);
    return safe + "'";
}

struct Script {
    std::string set, data, curves;
    int blocks = 0;

    // A curve of lines "x y", and how gnuplot is to draw it.
    void curve(const std::string& points, const std::string& drawn) {
        if (points.empty()) return;
        data += fmt::format("$block{} << E\n{}E\n", blocks, points);
        curves += fmt::format("{}$block{} {}", blocks ? ", " : "", blocks, drawn);
        ++blocks;
    }
};

void draw(const Script& script, const std::filesystem::path& file, int width, int height) {
    if (script.blocks == 0) return;
    std::filesystem::remove(file);
    const std::string text = fmt::format(
        "set terminal svg size {},{} dynamic noenhanced background '#ffffff'\nset output {}\n"
        "set grid lc rgb '#dddddd'\nset key outside right\n{}{}plot {}\n",
        width, height, in_quotes(file.string()), script.set, script.data, script.curves);
    FILE* pipe = popen("gnuplot", "w");
    if (pipe) std::fputs(text.c_str(), pipe);
    const int status = pipe ? pclose(pipe) : -1;
    if (status != 0 || !std::filesystem::exists(file)) {
        throw Error(Error::Code::device,
                    "gnuplot could not plot " + file.string() + "; install it: gnuplot-nox");
    }
}

std::string title(scene::Method method) {
    return fmt::format("title {}", in_quotes(std::string(scene::name(method))));
}

// A curve a method: lines(standing, contest, its number) of each that was drawn.
using Line = std::function<std::string(const Standing&, const Contest&, std::size_t)>;
void curves(Script& script, const std::vector<Contest>& contests, const Line& line,
            const std::string& with) {
    for (std::size_t k = 0; k < contests.front().standings.size(); ++k) {
        std::string points;
        for (std::size_t c = 0; c < contests.size(); ++c) {
            const Standing& standing = contests[c].standings[k];
            if (standing.refused.empty()) points += line(standing, contests[c], c);
        }
        script.curve(points, fmt::format("using 1:2 with {} {} {}", with, style(k),
                                         title(contests.front().standings[k].method)));
    }
}

void plot_wrong(const std::vector<Contest>& contests, const std::filesystem::path& file) {
    const double foot = 0.3e6 / (double(contests.front().size) * contests.front().size);
    Script script;
    script.set = fmt::format(
        "set logscale xy\nset format y '%g'\nset xlabel 'ms a frame, in those of amp-sign on the "
        "same surface'\nset ylabel 'wrong pixels, ppm ({:.3g}: none)'\nset yrange [{}:*]\n",
        foot, foot / 1.5);
    curves(
        script, contests,
        [&](const Standing& s, const Contest&, std::size_t) {
            return fmt::format("{} {}\n", 1 / s.against_own,
                               std::max(s.count.errors.wrong_ppm(), foot));
        },
        "points");
    draw(script, file, 760, 480);
}

void plot_ratio(const std::vector<Contest>& contests, const std::filesystem::path& file) {
    Script script;
    std::string names;
    double least = 1, most = 1;
    for (std::size_t k = 0; k < contests.size(); ++k) {
        for (const Standing& s : contests[k].standings) {
            if (!s.refused.empty()) continue;
            least = std::min(least, s.against_equal);
            most = std::max(most, s.against_equal);
        }
        names += fmt::format("{}{} {}", k ? ", " : "", in_quotes(contests[k].subject), k);
    }
    script.set = fmt::format(
        "set logscale y\nset format y '%g'\nset ylabel 'times as fast as amp-sign at equal "
        "accuracy'\nset xtics rotate by 60 right font ',10' ({})\nset xrange [-0.5:{}]\nset yrange "
        "[{}:{}]\n",
        names, double(contests.size()) - 0.5, least / 1.3, most * 1.5);
    curves(
        script, contests,
        [](const Standing& s, const Contest&, std::size_t at) {
            return fmt::format("{} {}\n", at, s.against_equal);
        },
        "points");
    std::string bounds;
    for (std::size_t k = 0; k < contests.size(); ++k) {
        for (const Standing& s : contests[k].standings) {
            if (s.refused.empty() && !s.reached)
                bounds += fmt::format("{} {}\n", k, s.against_equal);
        }
    }
    script.curve(bounds,
                 "using 1:2:(0):(0.3*$2) with vectors head size graph 0.008,25 lc rgb '#808080' "
                 "title 'at least'");
    draw(script, file, std::max(700, 260 + 24 * int(contests.size())), 520);
}

void plot_growth(const std::vector<Growth>& growth, const std::string& kind,
                 const std::string& label, double peak, const std::filesystem::path& file) {
    Script script;
    script.set = fmt::format("set logscale xy\nset format y '%g'\nset xlabel '{}'\nset ylabel 'ns "
                             "a ray'\n",
                             label);
    std::vector<std::pair<std::string, scene::Method>> lines;
    std::vector<std::string> subjects;
    std::vector<scene::Method> methods;
    std::set<int> ticks;
    const auto number = [](auto& known, const auto& value) {
        const auto at = std::find(known.begin(), known.end(), value);
        if (at != known.end()) return std::size_t(at - known.begin());
        known.push_back(value);
        return known.size() - 1;
    };
    for (const Growth& g : growth) {
        if (g.kind != kind) continue;
        number(lines, std::pair(g.subject, g.method));
        number(subjects, g.subject);
        number(methods, g.method);
        ticks.insert(g.at);
    }
    for (const auto& [subject, method] : lines) {
        std::string points, least;
        for (const Growth& g : growth) {
            if (g.kind == kind && g.subject == subject && g.method == method &&
                g.timing.refused.empty()) {
                points += fmt::format("{} {}\n", g.at, g.ns_a_ray());
                if (g.operations > 0) least += fmt::format("{} {}\n", g.at, g.least_ns_a_ray(peak));
            }
        }
        const std::string both = subjects.size() > 1
                                     ? fmt::format("{}, {}", subject, scene::name(method))
                                     : std::string(scene::name(method));
        script.curve(points, fmt::format("using 1:2 with linespoints dt {} {} title {}",
                                         1 + number(subjects, subject),
                                         style(number(methods, method)), in_quotes(both)));
        // The machine's limit for these evaluations.
        script.curve(least, fmt::format("using 1:2 with lines dt 3 lc rgb '{}' title {}",
                                        colours[number(methods, method) % std::size(colours)],
                                        in_quotes(both + ", F at the peak")));
    }
    if (ticks.empty()) return;
    script.set += fmt::format("set xtics ({})\nset xrange [{}:{}]\n", fmt::join(ticks, ", "),
                              0.8 * *ticks.begin(), 1.25 * *ticks.rbegin());
    draw(script, file, 760, 460);
}

} // namespace

void plot(const Results& results, const std::filesystem::path& folder) {
    if (!results.surfaces.empty()) {
        plot_wrong(results.surfaces, folder / "wrong.svg");
        plot_ratio(results.surfaces, folder / "ratio.svg");
    }
    const auto grown = [&](const std::string& kind, const std::string& label) {
        plot_growth(results.growth, kind, label, results.peak, folder / (kind + ".svg"));
    };
    grown("resolution", "pixels a side");
    grown("blobs", "blobs");
    grown("degree", "degree");
    grown("lights", "lights");
}

} // namespace isomotion::bench
