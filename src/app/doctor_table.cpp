#include "app/doctor_table.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/speed_probe.h"

namespace isomotion::app {
namespace {

using Json = nlohmann::ordered_json;

std::string text(const Json& value) { return value.get<std::string>(); }

std::string line(const std::string& name, const std::string& rest) {
    return fmt::format("{:<8} {}\n", name, rest);
}

// Says what is wrong, where something is.
std::string or_reason(const Json& part, const std::string& fine) {
    const std::string reason = part.contains("reason") ? text(part["reason"]) : "";
    return fine.empty() || reason.empty() ? fine + reason : fine + "; " + reason;
}

std::string disk(const Json& disk) {
    std::string all;
    if (disk.contains("free_bytes")) {
        all = fmt::format("{:.1f} GB free in ", disk["free_bytes"].get<double>() / 1e9);
    }
    all += text(disk["folder"]);
    return or_reason(disk, disk["writable"].get<bool>()
                               ? all + "; a file is written, brought to the disk and renamed"
                               : all);
}

std::string ffmpeg(const Json& ffmpeg) {
    if (!ffmpeg.contains("movies")) return or_reason(ffmpeg, "");
    std::string all =
        fmt::format("{}, version {}; movies:", text(ffmpeg["program"]), text(ffmpeg["version"]));
    for (const auto& [ending, works] : ffmpeg["movies"].items()) {
        all += fmt::format(" {}{}", ending, works.get<bool>() ? "" : " (no encoder)");
    }
    return all;
}

std::string error(const Json& error) {
    return error.is_null() ? "NaN" : fmt::format("{:.3g}", error.get<double>());
}

std::string arithmetic(const Json& arithmetic) {
    std::string all;
    if (arithmetic.contains("reason")) {
        return line("", "arithmetic is not known: " + text(arithmetic["reason"]));
    }
    for (const Json& behaviour : arithmetic["behaviours"]) {
        all +=
            line("", fmt::format("{:<22} {}{}", text(behaviour["what"]), text(behaviour["found"]),
                                 behaviour["ieee"].get<bool>() ? "" : "   (!)"));
    }
    all += line("", fmt::format("{:<32}{:>8} {:>9}   {}", "largest errors in ulp", "driver",
                                "isomotion", "driver's worst at"));
    for (const Json& function : arithmetic["errors"]) {
        const std::string range = fmt::format("{:g} .. {:g}", function["from"].get<double>(),
                                              function["to"].get<double>());
        all += line("", fmt::format("{:<10}{:<22}{:>8} {:>9}   {:.9g}", text(function["function"]),
                                    range, error(function["driver"]), error(function["own"]),
                                    function["driver_at"].get<double>()));
    }
    return all;
}

// The name of the first back end with this arithmetic.
std::string first_with(const Json& arithmetic, const Json& back_ends) {
    for (const Json& found : back_ends) {
        if (found.contains("arithmetic") && found["arithmetic"] == arithmetic) {
            return text(found["name"]);
        }
    }
    return "";
}

// Why a back end does not work. Which drivers to install is said only where none works.
std::string why_not(const Json& found, const Json& all) {
    std::string reason = text(found["reason"]);
    const bool one_works =
        std::ranges::any_of(all, [](const Json& each) { return each["works"].get<bool>(); });
    if (one_works) reason.resize(std::min(reason.find("\ninstall an OpenGL"), reason.size()));
    return reason;
}

// The speed of hardware. That of software renderers is not known, as it takes long to measure.
std::string speed(const Json& operations) {
    const double fragment = operations["fragment"].get<double>();
    const double compute = operations["compute"].get<double>();
    if (fragment == 0) return "";
    std::string words = fmt::format("{:.3g} Gflop/s in fragment shaders", 1e-9 * fragment);
    if (compute > 0) words += fmt::format(", {:.3g} in compute shaders", 1e-9 * compute);
    return line("", words);
}

std::string back_end(const Json& found, const Json& all) {
    const std::string name = text(found["name"]);
    if (!found["works"].get<bool>()) return line(name, "does not work: " + why_not(found, all));
    const Json& limits = found["limits"];
    const Json& compute = found["compute"];
    const std::string same = first_with(found["arithmetic"], all);
    return line(name, "works: " + text(found["backend"])) +
           line("", text(found["vendor"]) + ", " + text(found["renderer"])) +
           line("", fmt::format("OpenGL {}, GLSL {}", text(found["opengl"]), text(found["glsl"]))) +
           line("", fmt::format("textures to {}, uniform blocks to {} bytes, texture buffers to {} "
                                "texels",
                                limits["texture_size"].get<int>(),
                                limits["uniform_block_bytes"].get<int>(),
                                limits["texture_buffer_texels"].get<int>())) +
           line("", compute["works"].get<bool>()
                        ? "compute shaders work; --stage auto: " + text(compute["automatic_stage"])
                        : text(compute["reason"])) +
           speed(found["operations_a_second"]) +
           (same == name ? arithmetic(found["arithmetic"])
                         : line("", fmt::format("arithmetic: the same as that of {}", same)));
}

} // namespace

std::string doctor_table(const Json& report) {
    const Json& files = report["files"];
    std::string all =
        line("files", files.contains("folder") ? text(files["folder"]) : text(files["reason"])) +
        line("cpus", fmt::format("{}", report["processors"].get<unsigned>())) +
        line("disk", disk(report["disk"])) + line("ffmpeg", ffmpeg(report["ffmpeg"])) +
        line("sbatch", report["sbatch"].contains("program") ? text(report["sbatch"]["program"])
                                                            : text(report["sbatch"]["reason"])) +
        line("fonts", "not needed: without one the window has ImGui's own");
    for (const Json& found : report["backends"]) all += back_end(found, report["backends"]);
    if (const std::string sentence = expectation(report); !sentence.empty())
        all += line("expect", sentence);
    return all;
}

} // namespace isomotion::app
