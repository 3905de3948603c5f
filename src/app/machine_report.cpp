#include "app/machine_report.h"

#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/child_process.h"
#include "base/file.h"
#include "scene/data_folder.h"

namespace isomotion::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

Json files() {
    try {
        return {{"folder", scene::data_folder().string()}};
    } catch (const std::exception& error) {
        return {{"reason", error.what()}};
    }
}

// Writes as frames are written: under another name, synced and renamed.
Json disk() {
    const fs::path folder = fs::current_path();
    Json found = {{"folder", folder.string()}};
    std::error_code error;
    if (const auto space = fs::space(folder, error); !error) found["free_bytes"] = space.available;
    const fs::path file = folder / fmt::format("isomotion-doctor-{}.txt", ::getpid());
    try {
        base::write_whole(file, std::as_bytes(std::span(std::string_view("isomotion doctor\n"))));
        fs::remove(file);
        found["writable"] = true;
    } catch (const std::exception& refusal) {
        found["writable"] = false;
        found["reason"] = refusal.what();
    }
    return found;
}

std::string told_by(const fs::path& program, const std::vector<std::string>& arguments) {
    base::ChildProcess child(program, arguments, base::Output::keep);
    child.finish_by(std::chrono::steady_clock::now() + 20s);
    return child.output();
}

// What image/movie.cpp asks of it, by the ending of a movie's name.
Json ffmpeg() {
    const auto program = base::find_program("ffmpeg");
    if (!program) return {{"reason", "not found on PATH: no movies (Debian: ffmpeg)"}};
    try {
        const std::string version = told_by(*program, {"-hide_banner", "-version"});
        const std::string encoders = told_by(*program, {"-hide_banner", "-encoders"});
        const auto has = [&](const char* encoder) {
            return encoders.find(fmt::format(" {} ", encoder)) != std::string::npos;
        };
        constexpr std::string_view before = "ffmpeg version ";
        const std::size_t begin = version.starts_with(before) ? before.size() : 0;
        return {{"program", program->string()},
                {"version", version.substr(begin, version.find_first_of(" \n", begin) - begin)},
                {"movies",
                 {{".mp4", has("libx264")}, {".webm", has("libvpx-vp9")}, {".gif", has("gif")}}}};
    } catch (const std::exception& error) {
        return {{"program", program->string()}, {"reason", error.what()}};
    }
}

Json sbatch() {
    const auto program = base::find_program("sbatch");
    if (program) return {{"program", program->string()}};
    return {{"reason", "not found on PATH: no farm to send frames to"}};
}

} // namespace

Json machine_report() {
    return {{"files", files()},
            {"processors", std::thread::hardware_concurrency()},
            {"disk", disk()},
            {"ffmpeg", ffmpeg()},
            {"sbatch", sbatch()}};
}

} // namespace isomotion::app
