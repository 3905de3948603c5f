// What a person does with mouse and keys: views, cameras, parameters, files.
#include "playing.h"

#include <chrono>
#include <set>
#include <thread>

#include "image/decode.h"
#include "player/draw/views.h"
#include "player/model/event_rings.h"

namespace isomotion::player {
namespace {

using testing::HasSubstr;

bool is_hit_of(const Json& line, std::int64_t least, std::int64_t most) {
    const auto hits = line["verdicts"][1].get<std::int64_t>();
    return least <= hits && hits <= most;
}

class Hands : public Playing {
protected:
    // Paused at the last frame, where the sphere is large; its line.
    Json begin() {
        play({"--paused", "sphere.toml"});
        key("End");
        return await_rest("the last frame", [](const Json& line) { return line["frame"] == 64; });
    }
};

TEST_F(Hands, EveryViewShowsAPictureOfItsOwn) {
    begin();
    std::set<std::vector<std::array<std::uint8_t, 3>>> pictures;
    const std::vector<std::string> views{"depth",    "normal",     "evaluations",
                                         "verdicts", "difference", "shaded"};
    for (const std::string& view : views) {
        mark();
        key(view == "shaded" ? "1" : std::to_string(2 + pictures.size()));
        const Json line =
            await_rest("the view " + view, [&](const Json& l) { return l["view"] == view; });
        // The screen may be a moment late.
        EXPECT_TRUE(screen_comes_to([&] { return !pictures.contains(picture(line)); })) << view;
        pictures.insert(picture(line));
    }
    EXPECT_EQ(pictures.size(), views.size());
    quit();
}

// A ball is born at (0, 0.4, -0.2), halfway between frames 32 and 33. Before it there is nothing in
// the picture but its ring.
TEST_F(Hands, ARingIsWhereAnEventIs) {
    write("sphere.toml", growing_sphere("x^2 + (y - 0.4)^2 + (z + 0.2)^2 - (r - 0.7)"));
    const cli::Ending found = run({"topology", "sphere.toml", "-o", "sphere.timeline.json"});
    ASSERT_EQ(found.code, 0) << found;
    play({"--paused", "--frames", "32-64", "sphere.toml"});
    const Json line = await_rest("frame 32", [](const Json& l) { return l["frame"] == 32; });
    const int width = line["size"][0], height = line["size"][1];
    scene::CameraAt camera;
    camera.position = {4, 1, 0.5};
    camera.up = {0, 0, 1};
    camera.fov = 40;
    const auto place = projected(camera, {0, 0.4, -0.2});
    ASSERT_TRUE(place);
    const glm::dvec2 middle(width / 2.0 + place->x * height, height / 2.0 - place->y * height);
    int inside = 0, outside = 0;
    const auto count = [&] {
        inside = outside = 0;
        const auto pixels = picture(line);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const auto& rgb = pixels[std::size_t(y * width + x)];
                const bool is_green = rgb[1] > rgb[0] + 50 && rgb[1] > rgb[2] + 15;
                if (!is_green) continue;
                ++(glm::distance(middle, {x + 0.5, y + 0.5}) < 20 ? inside : outside);
            }
        }
    };
    const auto has_ring = [&] {
        count();
        return inside > 40;
    };
    EXPECT_TRUE(screen_comes_to(has_ring))
        << inside << " pixels at " << middle.x << ' ' << middle.y;
    EXPECT_EQ(outside, 0);
    key("e");
    EXPECT_TRUE(screen_comes_to([&] { return !has_ring() && inside + outside == 0; }));
    key("e");
    EXPECT_TRUE(screen_comes_to(has_ring));
    quit();
}

TEST_F(Hands, TheMouseTurnsTheCameraAndAKeyResetsIt) {
    write("sphere.toml", growing_sphere("x^2 + y^2 + 4*z^2 - r^2"));
    const Json before = begin();
    const auto verdicts = before["verdicts"];
    mark();
    drag({300, 300}, {300, 420});
    const Json turned =
        await_rest("a turned picture", [&](const Json& l) { return l["verdicts"] != verdicts; });
    EXPECT_EQ(turned["frame"], before["frame"]);
    mark();
    key("r");
    await_rest("the scene's own camera", [&](const Json& l) { return l["verdicts"] == verdicts; });
    mark();
    EXPECT_TRUE(display().drive({"mousemove", "300", "300", "click", "4", "click", "4"}));
    await_rest("a nearer picture",
               [&](const Json& l) { return l["verdicts"][1] > before["verdicts"][1]; });
    mark();
    key("f");
    const Json fitted = await_rest("all of the bounds", [&](const Json& l) {
        return l["verdicts"][1] < before["verdicts"][1];
    });
    EXPECT_GT(fitted["verdicts"][1], 0);
    quit();
}

TEST_F(Hands, ASliderHoldsAParameterUntilItIsGivenBack) {
    const Json before = begin();
    const auto verdicts = before["verdicts"];
    mark();
    drag(place_of("slider r", 0.8), place_of("slider r", 0.35));
    const Json held = await_rest("a smaller sphere",
                                 [&](const Json& l) { return l["verdicts"][1] < verdicts[1]; });
    mark();
    key("Home"); // the scene's own would be a dot
    const Json first = await_rest("the first frame", [](const Json& l) { return l["frame"] == 1; });
    EXPECT_EQ(first["verdicts"], held["verdicts"]);
    mark();
    click(place_of("give back r"));
    await_rest("a dot", [&](const Json& l) { return l["verdicts"][1] < held["verdicts"][1]; });
    quit();
}

TEST_F(Hands, AFileThatChangesIsReadAgain) {
    const Json before = begin();
    const auto hits = before["verdicts"][1].get<std::int64_t>();
    mark();
    write("sphere.toml", growing_sphere("x^2 + y^2 + z^2 - r^2/4"));
    const Json smaller = await_rest(
        "a smaller sphere", [&](const Json& l) { return is_hit_of(l, hits / 5, hits / 3); });
    EXPECT_EQ(smaller["frame"], 64) << "the time is kept";
    mark();
    write("sphere.toml", growing_sphere("x^2 + y^2 + z^2 - q"));
    const Json error = await("an error", [](const Json& l) { return l.contains("error"); });
    EXPECT_THAT(error["error"].get<std::string>(), HasSubstr("sphere.toml:7: surface.formula: "));
    mark();
    write("sphere.toml", growing_sphere());
    await_rest("the sphere again", [&](const Json& l) { return l["verdicts"][1] == hits; });
    quit();
}

TEST_F(Hands, SavesThePictureAsItIsShown) {
    const Json before = begin();
    drag(place_of("slider r", 0.8), place_of("slider r", 0.35));
    mark();
    drag({300, 300}, {340, 420});
    const Json line = await_rest("a held sphere, turned", [&](const Json& l) {
        return l["verdicts"][1] < before["verdicts"][1];
    });
    EXPECT_TRUE(display().drive({"mousemove", std::to_string(Display::width - 1), "0"}));
    key("F12");
    const auto file = *this / "out/sphere.0064.png";
    ASSERT_TRUE(screen_comes_to([&] { return std::filesystem::exists(file); }));
    const auto codes = shaded(image::decode(file)).rgba;
    EXPECT_TRUE(screen_comes_to([&] {
        const auto pixels = picture(line);
        if (codes.size() != 4 * pixels.size()) return false;
        for (std::size_t k = 0; k < 4 * pixels.size(); ++k) {
            if (k % 4 != 3 && codes[k] != pixels[k / 4][k % 4]) return false;
        }
        return true;
    }));
    quit();
}

TEST_F(Hands, SavesAPictureWhateverTheSceneIsCalled) {
    write("a#1 %d.toml", growing_sphere());
    play({"--paused", "a#1 %d.toml"});
    await_rest("the first frame");
    key("F12");
    EXPECT_TRUE(
        screen_comes_to([&] { return std::filesystem::exists(*this / "out/a_1 _d.0001.png"); }));
    quit();
}

TEST_F(Hands, AHeldButtonCostsNothing) {
    begin();
    mark();
    EXPECT_TRUE(display().drive({"mousemove", "300", "300", "sleep", "0.1", "mousedown", "1",
                                 "sleep", "0.1", "mousemove", "300", "360"}));
    await("a turned picture", [](const Json& l) { return l.contains("verdicts"); });
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const double before = cpu_seconds();
    std::this_thread::sleep_for(std::chrono::seconds(2));
    EXPECT_LE(cpu_seconds() - before, 0.2) << "in 2 s";
    mark();
    EXPECT_TRUE(display().drive({"mouseup", "1"}));
    await_rest("the whole picture");
    quit();
}

TEST_F(Hands, SavesTheRangeWhileTheWindowGoesOn) {
    begin();
    click(place_of("save frames")); // in sight without scrolling
    mark();
    key("Home");
    await("a picture meanwhile", [](const Json& l) { return l.value("frame", 0) == 1; });
    EXPECT_TRUE(
        screen_comes_to([&] { return std::filesystem::exists(*this / "out/sphere.0064.png"); }));
    EXPECT_EQ(image::decode(*this / "out/sphere.0001.png").width, 64);
    quit();
}

TEST_F(Hands, AButtonOpensTheGallery) {
    begin();
    click(place_of("gallery"));
    mark();
    click(place_of("scene barth_decic"));
    await("its picture",
          [](const Json& l) { return l.contains("verdicts") && l["verdicts"][1] > 0; });
    quit();
}

TEST_F(Hands, TheGalleryOpensAScene) {
    play({});
    click(place_of("scene barth_decic"));
    await("its picture",
          [](const Json& l) { return l.contains("verdicts") && l["verdicts"][1] > 0; });
    EXPECT_TRUE(display().drive({"search", "--name", "345 nodes - isomotion"}));
    quit();
}

TEST_F(Hands, TheCameraIsRemembered) {
    write("sphere.toml", growing_sphere("x^2 + y^2 + 4*z^2 - r^2"));
    const Json before = begin();
    mark();
    drag({300, 300}, {300, 420});
    const Json turned = await_rest(
        "a turned picture", [&](const Json& l) { return l["verdicts"] != before["verdicts"]; });
    quit();
    EXPECT_EQ(begin()["verdicts"], turned["verdicts"]);
}

} // namespace
} // namespace isomotion::player
