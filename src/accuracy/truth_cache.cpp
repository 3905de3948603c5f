#include "accuracy/truth_cache.h"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>

#include "base/file.h"
#include "base/fingerprint.h"

namespace isomotion::accuracy {
namespace fs = std::filesystem;
namespace {

// Changes with the certifying itself: what older programs wrote is not read.
constexpr std::string_view version = "isomotion truth 5";

static_assert(std::is_trivially_copyable_v<roots::FirstRoot>);

void add(base::Fingerprint& print, const formula::Field& field, const scene::OneSurfaceAt& now) {
    print.add(formula::identity(field));
    const auto add_values = [&](std::initializer_list<double> values) {
        print.add_values(std::span(values.begin(), values.size()));
    };
    print.add_values(std::span(now.surface.bindings.parameters));
    for (const auto& array : now.surface.bindings.arrays) {
        add_values({double(array.count)});
        for (const auto& field : array.fields) print.add_values(std::span(field));
    }
    for (const scene::SectionAt& section : now.scene.sections) {
        add_values({double(section.is_ball), section.where.x, section.where.y, section.where.z,
                    section.reach});
    }
    const scene::CameraAt& camera = now.scene.camera;
    const scene::PlacementAt& place = now.surface.placement;
    for (const glm::dvec3& v :
         {now.surface.bounds.min, now.surface.bounds.max, now.surface.bounds.centre,
          place.translate, place.rotate[0], place.rotate[1], place.rotate[2], camera.position,
          camera.target, camera.up}) {
        add_values({v.x, v.y, v.z});
    }
    add_values({double(now.surface.bounds.shape == scene::Bounds::Shape::box),
                now.surface.bounds.radius, place.scale, camera.fov, camera.height, camera.zoom,
                double(camera.projection == scene::Camera::Projection::orthographic)});
}

std::string fingerprint(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                        const roots::Budget& budget) {
    base::Fingerprint print;
    print.add(version);
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
        add(print, *scene.surfaces[k].field, {now, k});
    const std::array settings{double(width), double(height),   double(budget.evaluations),
                              budget.narrow, budget.narrowest, budget.bracket};
    print.add_values(std::span<const double>(settings));
    return print.text();
}

// After the version: evaluations, then the roots, then the fingerprint of both.
struct Contents {
    std::string bytes;
    std::string sum() const { return base::Fingerprint().add(bytes).text(); }
};

std::optional<roots::Truth> read(const fs::path& file, int width, int height) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    roots::Truth truth{width, height, {}, 0};
    truth.roots.resize(std::size_t(width) * std::size_t(height));
    const std::size_t size =
        sizeof(truth.evaluations) + truth.roots.size() * sizeof(roots::FirstRoot);
    if (text.size() < version.size() + size || !text.starts_with(version)) return std::nullopt;
    const Contents contents{text.substr(version.size(), size)};
    if (text.substr(version.size() + size) != contents.sum()) return std::nullopt;
    std::memcpy(&truth.evaluations, contents.bytes.data(), sizeof(truth.evaluations));
    std::memcpy(truth.roots.data(), contents.bytes.data() + sizeof(truth.evaluations),
                truth.roots.size() * sizeof(roots::FirstRoot));
    return truth;
}

void write(const fs::path& file, const roots::Truth& truth) {
    Contents contents;
    contents.bytes.append(reinterpret_cast<const char*>(&truth.evaluations),
                          sizeof(truth.evaluations));
    contents.bytes.append(reinterpret_cast<const char*>(truth.roots.data()),
                          truth.roots.size() * sizeof(roots::FirstRoot));
    const std::string text = std::string(version) + contents.bytes + contents.sum();
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    try {
        base::write_whole(file, std::as_bytes(std::span(text)));
    } catch (const base::FileError&) {
        // A disk that is full or read-only: certified again next time.
    }
}

} // namespace

fs::path truth_cache_folder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache && *cache == '/') return fs::path(cache) / "isomotion" / "truth";
    const char* home = std::getenv("HOME");
    if (home && *home == '/') return fs::path(home) / ".cache" / "isomotion" / "truth";
    return {};
}

roots::Truth remembered_truth(const scene::Scene& scene, const scene::SceneAt& now, int width,
                              int height, const roots::Certifying& how, const fs::path& folder) {
    if (folder.empty()) return roots::certify(scene, now, width, height, how);
    const fs::path file = folder / (fingerprint(scene, now, width, height, how.budget) + ".bin");
    if (auto known = read(file, width, height)) return *std::move(known);
    roots::Truth truth = roots::certify(scene, now, width, height, how);
    write(file, truth);
    return truth;
}

} // namespace isomotion::accuracy
