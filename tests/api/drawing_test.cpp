#include <cmath>
#include <filesystem>

#include "api/error_code.h"

namespace isomotion {
namespace {

namespace fs = std::filesystem;

Device& device() {
    static Device device;
    return device;
}

Scene ball() {
    return Scene::parse(
        "[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\nbounds = { sphere = 1.5 }\n"
        "[camera]\nprojection = 'orthographic'\nposition = [0, 5, 0]\nheight = 4\n"
        "[output]\nsize = [64, 48]\nbackground = 'transparent'\n[time]\nframes = 5\n");
}

TEST(Drawing, HasPlanesOfTheSceneSize) {
    Renderer renderer(device(), ball(), {.channels = {"z", "verdict"}});
    const Picture picture = renderer.draw(1);
    EXPECT_EQ(picture.width, 64);
    EXPECT_EQ(picture.height, 48);
    for (const char* name : {"R", "G", "B", "A", "Z", "verdict"}) {
        ASSERT_NE(picture.find(name), nullptr) << name;
        EXPECT_EQ(picture.find(name)->values.size(), 64u * 48u) << name;
    }
    EXPECT_EQ(picture.find("N.X"), nullptr);
    EXPECT_EQ(picture.misses + picture.hits, 64 * 48);
    // A disc of radius 12 pixels.
    EXPECT_NEAR(double(picture.hits), M_PI * 12 * 12, 10);
    EXPECT_GT(picture.evaluations(), picture.hits);
    EXPECT_EQ(picture.rays(), 64 * 48);
    ASSERT_FALSE(picture.kinds.empty());
    EXPECT_EQ(picture.kinds.front().name, "eye");
    EXPECT_GT(picture.kinds.front().most, 1);
    EXPECT_TRUE(picture.proofs.empty());
    // The eye is 5 away from the middle, whose nearest point is 4 away.
    const float depth = picture.find("Z")->values[64 * 24 + 32];
    EXPECT_NEAR(double(depth), 4, 0.01);
}

TEST(Drawing, CountsProofs) {
    const Picture picture = Renderer(device(), ball().with("isolation.certify", "true")).draw(1);
    std::int64_t all = 0, proved = 0;
    for (const Picture::Proof& proof : picture.proofs) {
        all += proof.pixels;
        if (proof.is_proved) proved += proof.pixels;
    }
    EXPECT_EQ(all, 64 * 48);
    EXPECT_GT(proved, 0.95 * double(all));
}

TEST(Drawing, BytesAreTheColoursOfThePlanes) {
    const Picture picture = Renderer(device(), ball()).draw(1);
    const std::vector<std::uint8_t> bytes = picture.rgba8();
    ASSERT_EQ(bytes.size(), 4u * 64 * 48);
    EXPECT_EQ(bytes[3], 0); // a corner
    const std::size_t middle = 64 * 24 + 32;
    EXPECT_EQ(bytes[4 * middle + 3], 255);
    const float light = picture.find("R")->values[middle];
    const double signal = 1.055 * std::pow(double(light), 1 / 2.4) - 0.055;
    EXPECT_NEAR(bytes[4 * middle], 255 * signal, 1);
}

TEST(Drawing, IsTheSameAgainAndOfAnotherSizeIfAsked) {
    Renderer renderer(device(), ball());
    const std::string first = renderer.draw(1).fingerprint();
    EXPECT_EQ(renderer.draw(3).fingerprint(), first); // nothing moves
    EXPECT_NE(Renderer(device(), ball().with("camera.height", 3)).draw(1).fingerprint(), first);
    Renderer wide(device(), ball(), {.width = 96, .height = 16});
    EXPECT_EQ(wide.draw(1).width, 96);
}

TEST(Drawing, ShowsWhatThereIsAfterEachSample) {
    Renderer renderer(device(), ball().with("output.samples", 4));
    std::vector<std::string> told_of;
    const Picture whole =
        renderer.draw(1, [&](const Picture& now) { told_of.push_back(now.fingerprint()); });
    ASSERT_EQ(told_of.size(), 4u);
    EXPECT_NE(told_of[0], told_of[3]);
    EXPECT_EQ(told_of[3], whole.fingerprint());
    EXPECT_EQ(whole.fingerprint(), renderer.draw(1).fingerprint());
    EXPECT_EQ(whole.rays(), 4 * 64 * 48);
}

TEST(Drawing, WritesFilesAndMovies) {
    const fs::path folder = fs::temp_directory_path() / "isomotion_api_drawing_test";
    fs::create_directories(folder);
    Renderer renderer(device(), ball());
    renderer.draw(1).write(folder / "a.png");
    renderer.draw(1).write(folder / "a.exr");
    EXPECT_GT(fs::file_size(folder / "a.png"), 100u);
    EXPECT_GT(fs::file_size(folder / "a.exr"), 1000u);
    EXPECT_EQ(told([&] { renderer.draw(1).write(folder / "a.tiff"); }).code, Error::Code::input);
    EXPECT_EQ(told([&] { renderer.draw(1).write(folder / "none/a.png"); }).code, Error::Code::file);
    const Watcher stops{.stop = [] { return true; }};
    const auto picture = [&](int k) { return renderer.draw(k + 1); };
    EXPECT_FALSE(write_movie(folder / "a.gif", ball(), 5, picture, stops));
    EXPECT_TRUE(write_movie(folder / "a.gif", ball(), 5, picture));
    EXPECT_TRUE(fs::exists(folder / "a.gif"));
    fs::remove_all(folder);
}

TEST(Drawing, TellsMistakesAndStops) {
    const Told unknown = told([] { Renderer(device(), ball(), {.channels = {"depth"}}); });
    EXPECT_EQ(unknown.code, Error::Code::setting);
    EXPECT_TRUE(unknown.words.starts_with("channels: ")) << unknown.words;
    EXPECT_NE(unknown.words.find("verdict"), std::string::npos) << unknown.words;
    EXPECT_EQ(told([] { Renderer(device(), ball(), {.width = 20'000}); }).code, Error::Code::limit);
    EXPECT_EQ(told([] { Renderer(device(), ball(), {.width = -1}); }).code, Error::Code::setting);
    EXPECT_EQ(told([] { Renderer(device(), ball(), {.stage = "vertex"}); }).code,
              Error::Code::input);
    EXPECT_EQ(told([] { Renderer(device(), ball()).draw(0); }).code, Error::Code::input);
    EXPECT_EQ(told([] { write_movie("a.avi", ball(), 1, [](int) { return Picture(); }); }).code,
              Error::Code::input);
    EXPECT_EQ(told([] { write_movie("a.gif", ball(), 1, nullptr); }).code, Error::Code::input);
    const Watcher stops{.stop = [] { return true; }};
    EXPECT_EQ(told([&] { Renderer(device(), ball(), {}, stops).draw(1); }).code,
              Error::Code::stopped);
    const Scene shrinks = Scene::parse("[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\n"
                                       "bounds = { sphere = 'r' }\n[parameters]\nr = '1 - t'\n"
                                       "[time]\nframes = 61\n");
    EXPECT_EQ(told([&] { Renderer(device(), shrinks).draw(61); }).code, Error::Code::input);
    EXPECT_FALSE(device().renderer().empty());
    EXPECT_FALSE(device().version().empty());
    EXPECT_FALSE(device().backend().empty());
}

// tests/unit/gpu compiles it.
TEST(Glsl, HasWhatAFormulaNeeds) {
    const std::string text = glsl_of(Formula("x^2 + b*y + sin(a*z)", {{"a", 1}, {"b", 2}}));
    EXPECT_TRUE(text.starts_with("#version 330"));
    for (const char* part : {"uniform vec4 parameters[1];", "float field(vec3 p)",
                             "vec3 field_gradient(vec3 p)", "im_sin"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(glsl_of(Formula("x - y")).find("parameters"), std::string::npos);
}

TEST(Page, HoldsItsScene) {
    const std::string page = page_of(ball());
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>")) << page.substr(0, 100);
    EXPECT_NE(page.find("x^2 + y^2 + z^2 - 1"), std::string::npos);
}

} // namespace
} // namespace isomotion
