#include "accuracy/report.h"

#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "base/child_process.h"
#include "base/file.h"
#include "base/file_text.h"
#include "image/encode.h"

namespace isomotion::accuracy {
namespace fs = std::filesystem;
namespace {

std::string label(const Report& report, std::size_t k) {
    return name(report.measurements[k].setting, report.isolation);
}

std::vector<bool> on_front(const Report& report) {
    std::vector<bool> on(report.measurements.size(), false);
    for (const std::size_t k : front(report.measurements)) on[k] = true;
    return on;
}

void write_text(const fs::path& file, const std::string& text) {
    base::write_whole(file, std::as_bytes(std::span(text)));
}

// White misses, grey hits; red missed, blue false hits, orange wrong roots, violet undecided.
std::vector<std::byte> wrong_picture(const Report& report, const Errors& errors) {
    image::Frame frame;
    frame.width = report.width;
    frame.height = report.height;
    const std::size_t area = errors.faults.size();
    for (const char* channel : {"R", "G", "B", "A"}) {
        frame.channels.push_back({channel, std::vector<float>(area, 1)});
    }
    constexpr float colours[][3] = {
        {0.85f, 0.85f, 0.85f}, {0.8f, 0, 0}, {0, 0.1f, 0.9f}, {0.9f, 0.3f, 0}, {0.4f, 0, 0.5f}};
    for (std::size_t k = 0; k < area; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            frame.channels[c].samples[k] = colours[std::size_t(errors.faults[k])][c];
        }
    }
    return image::encode(frame, image::Format::png8);
}

// What gnuplot writes to its standard output: no name of the user's is in a script.
std::string plotted(const std::string& script) {
    constexpr const char* failed = "gnuplot could not plot the report; install it: gnuplot-nox";
    const auto gnuplot = base::find_program("gnuplot");
    if (!gnuplot) throw Error(Error::Code::device, failed);
    base::ChildProcess plotting(*gnuplot, {}, base::Output::keep);
    const bool done = plotting.feed(std::as_bytes(std::span(script))) && plotting.finish();
    std::string picture = plotting.output();
    if (!done || picture.empty()) throw Error(Error::Code::device, failed);
    return picture;
}

// Writes one line a point: its time and its wrong pixels in ppm. A point without any is at the foot
// of the logarithmic axis.
void plot(const Report& report, const fs::path& folder) {
    const double pixels = double(report.measurements.front().errors.pixels);
    const double foot = 0.3e6 / pixels;
    std::string script =
        fmt::format("set logscale xy\nset format y '%g'\nset xlabel 'ms a frame'\n"
                    "set ylabel 'wrong pixels, ppm ({:.3g}: none)'\nset yrange [{}:1e6]\nset grid\n"
                    "set key outside right\nset offsets graph 0.02, graph 0.02, 0, 0\n",
                    foot, foot / 1.5);
    std::string curves;
    const auto block = [&](const std::string& id, const std::vector<std::size_t>& points) {
        script += "$" + id + " << E\n";
        for (const std::size_t k : points) {
            const Measurement& m = report.measurements[k];
            script += fmt::format("{} {}\n", m.ms, std::max(m.errors.wrong_ppm(), foot));
        }
        script += "E\n";
    };
    int methods = 0;
    for (const auto& entry : scene::method_traits) {
        std::vector<std::size_t> points;
        for (std::size_t k = 0; k < report.measurements.size(); ++k) {
            if (report.measurements[k].setting.method == entry.method) points.push_back(k);
        }
        if (points.empty()) continue;
        const std::string id = fmt::format("m{}", methods++);
        block(id, points);
        curves += fmt::format("${} with points pt 7 ps 0.8 title '{}', ", id, entry.name);
    }
    block("front", front(report.measurements));
    curves += "$front with lines lw 2 lc rgb '#404040' title 'front'";
    const auto draw = [&](const std::string& terminal, const char* name) {
        const std::string picture =
            plotted(script + "set terminal " + terminal + "\nplot " + curves + "\n");
        base::write_whole(folder / name, std::as_bytes(std::span(picture)));
    };
    draw("svg size 760,460 dynamic background '#ffffff'", "accuracy.svg");
    draw("pngcairo size 760,460", "accuracy.png");
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return safe;
}

std::string page(const Report& report, const fs::path& folder,
                 const std::vector<std::vector<std::byte>>& pictures) {
    constexpr std::size_t most_of_a_plot = 16 << 20;
    std::string svg = base::file_text(folder / "accuracy.svg", most_of_a_plot);
    svg = svg.substr(svg.find("<svg"));
    std::string html = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>{0}</title>\n<style>"
        "body{{font:15px sans-serif;max-width:1100px;margin:2em auto}}table{{border-collapse:"
        "collapse}}td,th{{padding:.2em .6em;text-align:right;border-bottom:1px solid #ddd}}"
        "td:first-child,th:first-child{{text-align:left}}.front{{font-weight:bold}}figure{{display:"
        "inline-block;margin:.5em}}figcaption{{font-size:12px}}</style>\n<h1>{0}</h1>\n<p>{1}x{2}, "
        "{3} frame{4} from {5}; {6}. Bold: nothing is faster and as right.</p>\n{7}\n",
        escaped(report.title), report.width, report.height, report.frames.size(),
        report.frames.size() == 1 ? "" : "s", report.frames.front(), escaped(report.machine), svg);
    html +=
        "<table><tr><th>setting<th>ms<th>spread<th>evaluations a ray<th>ns<th>wrong ppm<th>"
        "missed<th>false<th>wrong root<th>depth p50, p99, max<th>normal p50, p99, max<th>NaN<th>"
        "limit<th>undecided<th>pops";
    const bool proofs = report.isolation.certify;
    html += proofs ? "<th>proved %<th>contradicted</tr>\n" : "</tr>\n";
    const std::vector<bool> best = on_front(report);
    for (std::size_t k = 0; k < report.measurements.size(); ++k) {
        const Measurement& m = report.measurements[k];
        const Errors& e = m.errors;
        html += fmt::format(
            "<tr{}><td>{}<td>{:.2f}<td>{:.0f}%<td>{:.1f}<td>{:.1f}<td>{:.1f}<td>{}<td>{}<td>{}<td>"
            "{:.2g}, {:.2g}, {:.2g}<td>{:.2g}, {:.2g}, {:.2g}<td>{}<td>{}<td>{}<td>{}",
            best[k] ? " class=\"front\"" : "", label(report, k), m.ms, 100 * m.spread,
            m.evaluations_a_ray(), m.ns_an_evaluation(), e.wrong_ppm(), e.missed, e.false_hits,
            e.wrong_roots, quantile(e.depth, 0.5), quantile(e.depth, 0.99), quantile(e.depth, 1),
            quantile(e.normal, 0.5), quantile(e.normal, 0.99), quantile(e.normal, 1), e.nan,
            e.step_limit, e.undecided, m.pops);
        if (proofs) {
            html += fmt::format("<td>{:.3f}<td>{}", 100 * render::proved_part(e.proofs),
                                e.contradicted);
        }
        html += "</tr>\n";
    }
    html +=
        "</table>\n<p>Depth in widths of a pixel along the ray, normals in degrees. Below, wrong "
        "pixels of the first frame: red missed, blue false hits, orange behind the first root, "
        "violet undecided.</p>\n";
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        html +=
            fmt::format("<figure><img width=\"256\" src=\"data:image/png;base64,{}\"><figcaption>"
                        "{}</figcaption></figure>\n",
                        base::base64(pictures[k]), label(report, k));
    }
    return html + "</html>\n";
}

// Of the picture of the k-th measurement.
std::string wrong_name(std::size_t k) { return fmt::format("wrong-{:02}.png", k + 1); }

} // namespace

std::string table(const Report& report) {
    std::string text = fmt::format(
        "  {:<34} {:>8} {:>5} {:>7} {:>6} {:>9} {:>7} {:>7} {:>7} {:>8} {:>7} {:>5} {:>5} {:>6} "
        "{:>5}\n",
        "setting", "ms", "+-", "evals", "ns", "wrong ppm", "missed", "false", "root", "depth99",
        "norm99", "NaN", "limit", "undec", "pops");
    const bool proofs = report.isolation.certify;
    if (proofs) text.insert(text.size() - 1, fmt::format(" {:>8} {:>6}", "proved %", "contra"));
    const std::vector<bool> best = on_front(report);
    for (std::size_t k = 0; k < report.measurements.size(); ++k) {
        const Measurement& m = report.measurements[k];
        const Errors& e = m.errors;
        text += fmt::format("{} {:<34} {:>8.2f} {:>4.0f}% {:>7.1f} {:>6.1f} {:>9.1f} {:>7} {:>7} "
                            "{:>7} {:>8.2g} {:>7.2g} {:>5} {:>5} {:>6} {:>5}\n",
                            best[k] ? '*' : ' ', label(report, k), m.ms, 100 * m.spread,
                            m.evaluations_a_ray(), m.ns_an_evaluation(), e.wrong_ppm(), e.missed,
                            e.false_hits, e.wrong_roots, quantile(e.depth, 0.99),
                            quantile(e.normal, 0.99), e.nan, e.step_limit, e.undecided, m.pops);
        if (proofs) {
            text.insert(text.size() - 1,
                        fmt::format(" {:>8.3f} {:>6}", 100 * render::proved_part(e.proofs),
                                    e.contradicted));
        }
    }
    return text;
}

std::string csv(const Report& report) {
    std::string text =
        "method,step,thresholds,bisections,safety,ms,spread,evaluations_per_ray,ns_per_evaluation,"
        "pixels,"
        "rays,missed,false_hits,wrong_roots,wrong_ppm,depth_p50,depth_p99,depth_max,normal_p50,"
        "normal_p99,normal_max,nan,step_limit,undecided,pops";
    const bool proofs = report.isolation.certify;
    text += proofs ? ",proved,contradicted\n" : "\n";
    for (const Measurement& m : report.measurements) {
        const Errors& e = m.errors;
        text +=
            fmt::format("{},{:g},{:g},{},{:g},{:.4f},{:.4f},{:.3f},{:.3f},{},{},{},{},{},{:.3f},",
                        scene::name(m.setting.method), m.setting.step, m.setting.thresholds,
                        m.setting.bisections, m.setting.safety, m.ms, m.spread,
                        m.evaluations_a_ray(), m.ns_an_evaluation(), e.pixels, e.rays, e.missed,
                        e.false_hits, e.wrong_roots, e.wrong_ppm());
        for (const auto* values : {&e.depth, &e.normal}) {
            for (const double part : {0.5, 0.99, 1.0}) {
                text += fmt::format("{:.4g},", quantile(*values, part));
            }
        }
        text += fmt::format("{},{},{},{}", e.nan, e.step_limit, e.undecided, m.pops);
        if (proofs) {
            text += fmt::format(",{:.6f},{}", render::proved_part(e.proofs), e.contradicted);
        }
        text += "\n";
    }
    return text;
}

std::string json(const Report& report) {
    nlohmann::ordered_json root{{"version", 1},
                                {"scene", report.title},
                                {"machine", report.machine},
                                {"frames", report.frames},
                                {"width", report.width},
                                {"height", report.height}};
    const std::vector<bool> best = on_front(report);
    for (std::size_t k = 0; k < report.measurements.size(); ++k) {
        const Measurement& m = report.measurements[k];
        const Errors& e = m.errors;
        const auto quantiles = [](const std::vector<float>& values) {
            return nlohmann::ordered_json{{"p50", quantile(values, 0.5)},
                                          {"p99", quantile(values, 0.99)},
                                          {"max", quantile(values, 1)}};
        };
        root["measurements"].push_back({{"method", scene::name(m.setting.method)},
                                        {"step", m.setting.step},
                                        {"thresholds", m.setting.thresholds},
                                        {"bisections", m.setting.bisections},
                                        {"safety", m.setting.safety},
                                        {"ms", m.ms},
                                        {"spread", m.spread},
                                        {"evaluations_per_ray", m.evaluations_a_ray()},
                                        {"ns_per_evaluation", m.ns_an_evaluation()},
                                        {"pixels", e.pixels},
                                        {"rays", e.rays},
                                        {"missed", e.missed},
                                        {"false_hits", e.false_hits},
                                        {"wrong_roots", e.wrong_roots},
                                        {"wrong_ppm", e.wrong_ppm()},
                                        {"depth", quantiles(e.depth)},
                                        {"normal", quantiles(e.normal)},
                                        {"nan", e.nan},
                                        {"step_limit", e.step_limit},
                                        {"undecided", e.undecided},
                                        {"pops", m.pops},
                                        {"front", bool(best[k])}});
        if (report.isolation.certify) {
            root["measurements"].back()["proved"] = render::proved_part(e.proofs);
            root["measurements"].back()["contradicted"] = e.contradicted;
        }
    }
    return root.dump(2) + "\n";
}

std::vector<std::string> files_written(std::size_t measurements) {
    std::vector<std::string> names{"accuracy.csv", "accuracy.json", "accuracy.svg", "accuracy.png",
                                   "index.html"};
    for (std::size_t k = 0; k < measurements; ++k) names.push_back(wrong_name(k));
    return names;
}

void write(const Report& report, const fs::path& folder) {
    fs::create_directories(folder);
    write_text(folder / "accuracy.csv", csv(report));
    write_text(folder / "accuracy.json", json(report));
    std::vector<std::vector<std::byte>> pictures;
    for (std::size_t k = 0; k < report.measurements.size(); ++k) {
        pictures.push_back(wrong_picture(report, report.measurements[k].errors));
        base::write_whole(folder / wrong_name(k), pictures.back());
    }
    plot(report, folder);
    write_text(folder / "index.html", page(report, folder, pictures));
}

} // namespace isomotion::accuracy
