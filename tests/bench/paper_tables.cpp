// The paper's tables measured again: every surface it names, as the catalogue has it, at the
// paper's step, seen whole by the default camera.
//
//   paper_tables [-o FOLDER] [--repeat N] [--only NAME]... [--backend B]
//
// writes paper-tables.csv and paper-tables.md to FOLDER (default: docs of the source tree).
//
// A ray is one that meets the surface's bounds; the others cost next to nothing. Times are medians
// of whole frames, upload to read-back, after a first one that compiles; the spread is the range of
// the frames over their median. Counts do not depend on the machine, times do.

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>
#include <unistd.h>

#include "machine.h"
#include "render/renderer.h"
#include "scene/data_folder.h"
#include "scene/reading/load.h"
#include "words.h"

namespace {

using namespace isomotion;

struct Arguments {
    std::string folder = ISOMOTION_SOURCE_DIR "/docs";
    std::string backend = "auto";
    int repeat = 3;
    std::vector<std::string> only;
};

struct Measurement {
    double ms = 0, spread = 0;
    double rays = 0, evaluations = 0;
    double step = 0;
    std::array<std::int64_t, 5> verdicts{};

    double frames_a_second() const { return 1e3 / ms; }
    double mega_rays_a_second() const { return rays / ms / 1e3; }
    double evaluations_a_ray() const { return evaluations / rays; }
    double ns_an_evaluation() const { return 1e6 * ms / evaluations; }
    std::int64_t bad() const {
        return verdicts[std::size_t(render::Verdict::step_limit)] +
               verdicts[std::size_t(render::Verdict::nan)];
    }
};

scene::Scene scene_of(const std::string& surface, const std::string& method) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("isomotion-table-" + std::to_string(getpid()) + ".toml");
    std::ofstream(file) << "[surface]\nuse = \"" << surface << "\"\n";
    scene::Scene scene = scene::load(file.string(), {"isolation.method=\"" + method + "\""});
    std::filesystem::remove(file);
    return scene;
}

Measurement measure(gpu::Context& context, const std::string& surface, const std::string& method,
                    int size, int repeat) {
    scene::Scene scene = scene_of(surface, method);
    scene.output.width = scene.output.height = size;
    const scene::SceneAt now = scene::at_frame(scene, 1);
    Measurement found;
    found.step = scene.surfaces[0].isolation.step;
    {
        render::Renderer counting(context, scene, {size, size, {shader::Channel::evaluations}, {}});
        const render::Picture picture = counting.draw(now);
        const auto& samples = picture.frame.find("evaluations")->samples;
        found.rays = double(
            std::count_if(samples.begin(), samples.end(), [](float count) { return count > 0; }));
        found.evaluations = double(picture.evaluations());
        found.verdicts = picture.verdicts;
    }
    render::Renderer renderer(context, scene, {size, size, {}, {}});
    renderer.draw(now);
    std::vector<double> ms;
    for (int k = 0; k < repeat; ++k) {
        ms.push_back(std::chrono::duration<double, std::milli>(renderer.draw(now).drawing).count());
    }
    std::sort(ms.begin(), ms.end());
    found.ms = ms[ms.size() / 2];
    found.spread = (ms.back() - ms.front()) / found.ms;
    return found;
}

class Tables {
public:
    explicit Tables(const Arguments& arguments)
        : arguments_(arguments)
        , context_(gpu::Context::create(gpu::parse_backend(arguments.backend)))
        , paper_(toml::parse_file(ISOMOTION_SOURCE_DIR "/tests/bench/paper_tables.toml")) {
        machine_ = bench::machine(context_->info());
        for (const auto& name : arguments.only) {
            if (!paper_.contains(name)) throw std::invalid_argument("no surface " + name);
        }
        for (const auto& [name, row] : paper_) {
            const std::string surface(name.str());
            const auto& only = arguments.only;
            if (only.empty() || std::find(only.begin(), only.end(), surface) != only.end()) {
                surfaces_.push_back(surface);
            }
        }
    }

    void write() {
        markdown_ = fmt::format(
            "# The paper's tables, measured again\n\n"
            "Singh & Narayanan 2010, Tables I to III, beside this renderer with the paper's own\n"
            "method and step; made by `build/release/tests/bench/paper_tables`.\n\n"
            "{}, {}. Median of {} frames each.\n\n"
            "A ray is one that meets the bounds of the surface; evaluations are samples of the\n"
            "field with its derivative along the ray. The paper frames its surfaces in ways it\n"
            "does not tell, here the bounds fill the picture.\n\n",
            machine_, bench::today(), arguments_.repeat);
        csv_ = "table,surface,method,size,step,ms,spread,fps,mrays_per_s,evaluations_per_ray,"
               "ns_per_evaluation,hits,step_limit,nan,paper_fps,machine,date\n";
        write_table_1();
        write_table_2();
        write_table_3();
        std::filesystem::create_directories(arguments_.folder);
        std::ofstream(arguments_.folder + "/paper-tables.csv") << csv_;
        std::ofstream(arguments_.folder + "/paper-tables.md") << markdown_;
        fmt::print("{0}/paper-tables.md\n{0}/paper-tables.csv\n", arguments_.folder);
    }

private:
    std::optional<double> printed(const std::string& surface, const std::string& column) const {
        return paper_[surface][column].value<double>();
    }
    static std::string cell(std::optional<double> value) {
        return value ? fmt::format("{:g}", *value) : "";
    }

    const Measurement& measured(int table, const std::string& surface, const std::string& method,
                                int size, std::optional<double> paper_fps) {
        const auto key = std::tuple(surface, method, size);
        auto it = measurements_.find(key);
        if (it == measurements_.end()) {
            fmt::print(stderr, "table {}: {} {} {}x{}\n", table, surface, method, size, size);
            it = measurements_
                     .emplace(key, measure(*context_, surface, method, size, arguments_.repeat))
                     .first;
        }
        const Measurement& m = it->second;
        csv_ += fmt::format("{},{},{},{},{:g},{:.3f},{:.3f},{:.2f},{:.3f},{:.2f},{:.3f},{},{},{},"
                            "{},\"{}\",{}\n",
                            table, surface, method, size, m.step, m.ms, m.spread,
                            m.frames_a_second(), m.mega_rays_a_second(), m.evaluations_a_ray(),
                            m.ns_an_evaluation(), m.verdicts[std::size_t(render::Verdict::hit)],
                            m.verdicts[std::size_t(render::Verdict::step_limit)],
                            m.verdicts[std::size_t(render::Verdict::nan)], cell(paper_fps),
                            machine_, bench::today());
        return m;
    }

    void write_table_1() {
        markdown_ +=
            "## Table I: 512x512, without shadow rays\n\n"
            "| surface | step | sign: evaluations a ray | ns an evaluation | Mray/s | fps | "
            "paper, GTX 280 | Taylor: evaluations a ray | ns an evaluation | Mray/s | fps | "
            "paper, GTX 280 |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
        for (const auto& surface : surfaces_) {
            std::string row, step;
            for (const auto& [method, column] :
                 {std::pair{"amp-sign", "sign"}, {"amp-taylor", "taylor"}}) {
                const auto paper = printed(surface, column);
                const Measurement& m = measured(1, surface, method, 512, paper);
                step = fmt::format("{:g}{}", m.step, printed(surface, "step") ? "" : " (ours)");
                row += fmt::format(" {:.1f} | {:.1f} | {:.2f} | {:.1f} | {} |",
                                   m.evaluations_a_ray(), m.ns_an_evaluation(),
                                   m.mega_rays_a_second(), m.frames_a_second(), cell(paper));
            }
            markdown_ += fmt::format("| {} | {} |{}\n", surface, step, row);
        }
    }

    void write_table_2() {
        markdown_ +=
            "\n## Table II: 1024x1024, sign test\n\n"
            "| surface | step | evaluations a ray | Mray/s | fps | paper, GTX 280 | paper, "
            "8800 GTX | Knoll et al., 8800 GTX |\n|---|---|---|---|---|---|---|---|\n";
        for (const auto& surface : surfaces_) {
            const auto paper = printed(surface, "amp_280");
            if (!paper) continue;
            const Measurement& m = measured(2, surface, "amp-sign", 1024, paper);
            markdown_ += fmt::format(
                "| {} | {:g} | {:.1f} | {:.2f} | {:.2f} | {} | {} | {} |\n", surface, m.step,
                m.evaluations_a_ray(), m.mega_rays_a_second(), m.frames_a_second(), cell(paper),
                cell(printed(surface, "amp_8800")), cell(printed(surface, "knoll_8800")));
        }
    }

    void write_table_3() {
        markdown_ +=
            "\n## Table III: 512x512, sign test, milliseconds a frame\n\n"
            "| surface | here | paper, one CPU core | paper, GTX 280 |\n|---|---|---|---|\n";
        for (const auto& surface : surfaces_) {
            const auto paper = printed(surface, "cpu_ms");
            if (!paper) continue;
            const auto fps = printed(surface, "sign");
            const Measurement& m = measured(3, surface, "amp-sign", 512, fps);
            markdown_ += fmt::format("| {} | {:.1f} | {} | {} |\n", surface, m.ms, cell(paper),
                                     fps ? fmt::format("{:.2f}", 1e3 / *fps) : "");
        }
    }

    Arguments arguments_;
    std::unique_ptr<gpu::Context> context_;
    toml::table paper_;
    std::string machine_;
    std::vector<std::string> surfaces_;
    std::map<std::tuple<std::string, std::string, int>, Measurement> measurements_;
    std::string csv_, markdown_;
};

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    isomotion::bench::Words words("measures the paper's tables again");
    words.text("-o,--output", arguments.folder, "folder for the two tables");
    words.text("--backend", arguments.backend, "auto, egl or osmesa");
    words.number("--repeat", arguments.repeat, "frames a median is taken of", {1, 1000});
    words.texts("--only", arguments.only, "surfaces, instead of all");
    if (const auto code = words.read(argc, argv)) return *code;
    try {
        Tables(arguments).write();
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
