#include "player/model/memory.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/fingerprint.h"

namespace isomotion::player {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;
using scene::CameraAt;

constexpr int version = 1;
constexpr int widest = 1 << 16;
constexpr const char* projections[] = {"perspective", "orthographic"};

// One name for a file, however it was reached.
fs::path one_name(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(file, error);
    return error ? fs::absolute(file, error) : whole;
}

int integer(const json& value, int least, int most) {
    if (!value.is_number_integer()) throw std::invalid_argument("has no integer where one belongs");
    const auto number = value.get<std::int64_t>();
    if (number < least || number > most) {
        throw std::invalid_argument(fmt::format("{} is not from {} to {}", number, least, most));
    }
    return int(number);
}

// A number above `least` and below `most`; everything ends as a float.
double number(const json& value, double least = -std::numeric_limits<float>::max(),
              double most = std::numeric_limits<float>::max()) {
    const double number = value.get<double>();
    if (least < number && number < most) return number;
    throw std::invalid_argument(fmt::format("{} is out of range", number));
}

double not_negative(const json& value) {
    return number(value, -std::numeric_limits<double>::denorm_min());
}

json from(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

glm::dvec3 vector(const json& value) {
    if (value.size() != 3) throw std::invalid_argument("a vector has three numbers");
    return {number(value.at(0)), number(value.at(1)), number(value.at(2))};
}

json from(const WindowPlace& window) {
    return {{"x", window.x},
            {"y", window.y},
            {"width", window.width},
            {"height", window.height},
            {"maximised", window.maximised}};
}

WindowPlace window(const json& value) {
    WindowPlace window;
    window.x = integer(value.at("x"), -widest, widest);
    window.y = integer(value.at("y"), -widest, widest);
    window.width = integer(value.at("width"), 1, widest);
    window.height = integer(value.at("height"), 1, widest);
    window.maximised = value.at("maximised").get<bool>();
    return window;
}

json from(const CameraAt& camera) {
    return {{"position", from(camera.position)},
            {"target", from(camera.target)},
            {"up", from(camera.up)},
            {"fov", camera.fov},
            {"height", camera.height},
            {"zoom", camera.zoom},
            {"aperture", camera.aperture},
            {"focus", camera.focus},
            {"projection", projections[std::size_t(camera.projection)]}};
}

// What scene::at would refuse of a scene is refused here too.
CameraAt camera(const json& value) {
    CameraAt camera;
    const auto projection = value.at("projection").get<std::string>();
    const auto known = std::ranges::find(projections, projection);
    if (known == std::end(projections)) {
        throw std::invalid_argument(fmt::format("there is no projection '{}'", projection));
    }
    camera.projection = scene::Camera::Projection(known - std::begin(projections));
    camera.position = vector(value.at("position"));
    camera.target = vector(value.at("target"));
    camera.up = vector(value.at("up"));
    if (camera.position == camera.target || camera.up == glm::dvec3(0)) {
        throw std::invalid_argument("a camera has no direction");
    }
    const bool is_flat = camera.projection == scene::Camera::Projection::orthographic;
    camera.fov = number(value.at("fov"), 0, 180);
    camera.height = is_flat ? number(value.at("height"), 0) : number(value.at("height"));
    camera.zoom = number(value.at("zoom"), 0);
    camera.aperture = not_negative(value.at("aperture"));
    camera.focus =
        camera.aperture > 0 ? number(value.at("focus"), 0) : not_negative(value.at("focus"));
    return camera;
}

template<class Read> void read_json(const fs::path& file, const Warn& warn, Read&& read) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return;
    try {
        const auto bytes = base::read_whole(file);
        const auto* begin = reinterpret_cast<const char*>(bytes.data());
        const json document = json::parse(begin, begin + bytes.size());
        if (integer(document.at("version"), 1, std::numeric_limits<int>::max()) > version) {
            throw std::invalid_argument("is of a newer version");
        }
        read(document);
    } catch (const base::FileError& error) {
        warn(error.what());
    } catch (const std::exception& error) { // of JSON, or of what it says
        warn(fmt::format("{}: is forgotten: {}", file.string(), error.what()));
    }
}

void write_json(const fs::path& file, const Warn& warn, json document) {
    document["version"] = version;
    // Bytes that are no UTF-8 stand in file names only: such a file is not found again.
    const std::string text = document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
    try {
        fs::create_directories(file.parent_path());
        base::write_whole(file, std::as_bytes(std::span(text)));
    } catch (const std::exception& error) {
        warn(fmt::format("not remembered: {}", error.what()));
    }
}

// The program's folder in the one that the variable names, or else in this one of HOME. The
// specification has relative paths ignored.
fs::path own_folder(const char* variable, const fs::path& usual) {
    const auto absolute = [](const char* name) -> fs::path {
        const char* value = std::getenv(name);
        return value && fs::path(value).is_absolute() ? fs::path(value) : fs::path();
    };
    if (const fs::path named = absolute(variable); !named.empty()) return named / "isomotion";
    const fs::path home = absolute("HOME");
    return home.empty() ? fs::path() : home / usual / "isomotion";
}

} // namespace

WindowPlace within(WindowPlace place, const std::vector<WorkArea>& areas) {
    if (areas.empty()) return place;
    const auto shared = [&](const WorkArea& area) {
        const auto along = [](std::int64_t a, int length, std::int64_t b, int other) {
            return std::max<std::int64_t>(0, std::min(a + length, b + other) - std::max(a, b));
        };
        return along(place.x, place.width, area.x, area.width) *
               along(place.y, place.height, area.y, area.height);
    };
    const WorkArea& area = *std::ranges::max_element(areas, {}, shared);
    place.width = std::min(place.width, area.width);
    place.height = std::min(place.height, area.height);
    place.x = std::clamp(place.x, area.x, area.x + area.width - place.width);
    place.y = std::clamp(place.y, area.y, area.y + area.height - place.height);
    return place;
}

Memory::Memory(fs::path folder, Warn warn)
    : folder_(std::move(folder))
    , warn_(warn ? std::move(warn) : [](const std::string&) {}) {}

fs::path Memory::file_of(const fs::path& scene) const {
    return folder_ / "scenes" /
           (base::Fingerprint().add(one_name(scene).native()).text() + ".json");
}

SceneMemory Memory::recall(const fs::path& scene) const {
    SceneMemory memory;
    if (folder_.empty()) return memory;
    read_json(file_of(scene), warn_, [&](const json& document) {
        SceneMemory read;
        if (document.contains("window")) read.window = window(document.at("window"));
        if (document.contains("camera")) read.camera = camera(document.at("camera"));
        memory = read;
    });
    return memory;
}

void Memory::remember(const fs::path& scene, const SceneMemory& memory) const {
    if (folder_.empty()) return;
    json document{{"scene", one_name(scene).string()}};
    if (memory.window) document["window"] = from(*memory.window);
    if (memory.camera) document["camera"] = from(*memory.camera);
    write_json(file_of(scene), warn_, std::move(document));
}

std::vector<fs::path> Memory::opened() const {
    std::vector<fs::path> scenes;
    if (folder_.empty()) return scenes;
    read_json(folder_ / "history.json", warn_, [&](const json& document) {
        std::vector<fs::path> read;
        for (const json& entry : document.at("opened")) {
            const fs::path scene = entry.get<std::string>();
            std::error_code ignored;
            if (fs::is_regular_file(scene, ignored)) read.push_back(scene);
        }
        scenes = std::move(read);
    });
    if (scenes.size() > most_opened) scenes.resize(most_opened);
    return scenes;
}

void Memory::add_opened(const fs::path& scene) const {
    if (folder_.empty()) return;
    const fs::path newest = one_name(scene);
    std::vector<fs::path> scenes = opened();
    std::erase(scenes, newest);
    scenes.insert(scenes.begin(), newest);
    if (scenes.size() > most_opened) scenes.resize(most_opened);
    json list = json::array();
    for (const fs::path& entry : scenes) list.push_back(entry.string());
    write_json(folder_ / "history.json", warn_, {{"opened", std::move(list)}});
}

fs::path state_folder() { return own_folder("XDG_STATE_HOME", ".local/state"); }

fs::path cache_folder() { return own_folder("XDG_CACHE_HOME", ".cache"); }

} // namespace isomotion::player
