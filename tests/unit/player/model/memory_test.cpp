#include "player/model/memory.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "unit/formula/testing.h"
#include "unit/image/places.h"

namespace isomotion::player::memory_test {
namespace {
namespace fs = std::filesystem;

using formula::Random;
using scene::CameraAt;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Remembering : public testing::Test {
protected:
    Memory memory() {
        return Memory(state, [this](const std::string& text) { warnings.push_back(text); });
    }
    fs::path scene(const std::string& name) const {
        std::ofstream(folder / name) << "title = \"" << name << "\"\n";
        return folder / name;
    }
    // The one file about scenes.
    fs::path scene_file() const {
        const fs::directory_iterator files(state / "scenes");
        return files->path();
    }
    static std::string text_of(const fs::path& file) {
        std::ifstream in(file);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    static void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

    image::TemporaryFolder folder;
    const fs::path state = folder / "not" / "there" / "yet";
    std::vector<std::string> warnings;
};

CameraAt random_camera(Random& random) {
    const auto number = [&] { return random.in(-1, 1) * std::exp(random.in(-30, 30)); };
    CameraAt camera;
    for (int k = 0; k < 3; ++k) {
        camera.position[k] = number();
        camera.target[k] = number();
        camera.up[k] = number();
    }
    camera.fov = random.in(1, 179);
    camera.height = std::abs(number());
    camera.zoom = std::abs(number());
    camera.aperture = random.below(2) == 0 ? 0 : std::abs(number());
    camera.focus = std::abs(number());
    camera.projection = random.below(2) == 0 ? scene::Camera::Projection::perspective
                                             : scene::Camera::Projection::orthographic;
    return camera;
}

void expect_same(const CameraAt& a, const CameraAt& b) {
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.target, b.target);
    EXPECT_EQ(a.up, b.up);
    EXPECT_EQ(a.fov, b.fov);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.zoom, b.zoom);
    EXPECT_EQ(a.aperture, b.aperture);
    EXPECT_EQ(a.focus, b.focus);
    EXPECT_EQ(a.projection, b.projection);
}

TEST_F(Remembering, KnowsNothingAtFirst) {
    EXPECT_FALSE(memory().recall(scene("a.toml")).window);
    EXPECT_FALSE(memory().recall(scene("a.toml")).camera);
    EXPECT_THAT(memory().opened(), IsEmpty());
    EXPECT_FALSE(fs::exists(state)) << "asking leaves no trace";
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(Remembering, BringsBackTheSameBits) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        SceneMemory kept;
        kept.camera = random_camera(random);
        kept.window =
            WindowPlace{random.below(4000) - 2000, random.below(4000) - 2000,
                        1 + random.below(4000), 1 + random.below(4000), random.below(2) == 0};
        memory().remember(scene("a.toml"), kept);
        const SceneMemory found = memory().recall(scene("a.toml"));
        ASSERT_TRUE(found.window && found.camera);
        EXPECT_EQ(*found.window, *kept.window);
        expect_same(*found.camera, *kept.camera);
    }
    EXPECT_THAT(warnings, IsEmpty());
    const fs::directory_iterator files(state / "scenes");
    EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "nothing half written is left";
}

TEST_F(Remembering, EachSceneHasItsOwn) {
    const fs::path a = scene("a.toml"), b = scene("b.toml");
    memory().remember(a, {WindowPlace{1, 2, 3, 4, false}, {}});
    memory().remember(b, {{}, CameraAt{}});
    EXPECT_EQ(memory().recall(a).window->width, 3);
    EXPECT_FALSE(memory().recall(a).camera);
    EXPECT_FALSE(memory().recall(b).window);
    EXPECT_TRUE(memory().recall(b).camera);
    // The same file by another way.
    fs::create_directory(folder / "inner");
    fs::create_symlink(a, folder / "inner" / "link.toml");
    EXPECT_TRUE(memory().recall(folder / "inner" / ".." / "a.toml").window);
    EXPECT_TRUE(memory().recall(folder / "inner" / "link.toml").window);
    // A camera that was reset is not remembered any more.
    memory().remember(b, {WindowPlace{1, 2, 3, 4, false}, {}});
    EXPECT_FALSE(memory().recall(b).camera);
}

TEST_F(Remembering, WhatIsBrokenIsForgottenWithAWarning) {
    const fs::path a = scene("a.toml");
    memory().remember(a, {WindowPlace{1, 2, 3, 4, false}, CameraAt{}});
    const fs::path file = scene_file();
    const std::string good = text_of(file);
    EXPECT_TRUE(memory().recall(a).window && memory().recall(a).camera);
    EXPECT_THAT(warnings, IsEmpty());
    const auto without = [&](const std::string& part, const std::string& other) {
        std::string text = good;
        const auto at = text.find(part);
        EXPECT_NE(at, text.npos) << part;
        return text.replace(at, part.size(), other);
    };
    for (const std::string& broken :
         std::vector<std::string>{"",
                                  "{",
                                  "[]",
                                  "null",
                                  "7",
                                  "{}",
                                  std::string(1, '\0'),
                                  std::string(100'000, '['),
                                  good.substr(0, good.size() / 2),
                                  without("\"version\": 1", "\"version\": 2"),
                                  without("\"version\": 1", "\"version\": \"1\""),
                                  without("\"width\": 3", "\"width\": 0"),
                                  without("\"width\": 3", "\"width\": 1e300"),
                                  without("\"width\": 3", "\"width\": 99999999999999"),
                                  without("\"width\": 3", "\"width\": 3.5"),
                                  without("\"height\": 4", "\"depth\": 4"),
                                  without("\"maximised\": false", "\"maximised\": 0"),
                                  without("\"fov\": 40.0", "\"fov\": 180"),
                                  without("\"fov\": 40.0", "\"fov\": null"),
                                  without("\"zoom\": 1.0", "\"zoom\": 0"),
                                  without("\"aperture\": 0.0", "\"aperture\": -1"),
                                  without("\"zoom\": 1.0", "\"zoom\": 1e60"),
                                  without("\"perspective\"", "\"fisheye\""),
                                  without("\"up\": [", "\"up\": [1,"),
                                  without("\"position\"", "\"position\": [0, 0, 0], \"was\"")}) {
        SCOPED_TRACE(broken.substr(0, 400));
        warnings.clear();
        put(file, broken);
        const SceneMemory found = memory().recall(a);
        EXPECT_FALSE(found.window);
        EXPECT_FALSE(found.camera);
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_THAT(warnings[0], HasSubstr(file.string()));
    }
    // It is written anew as if nothing had been.
    warnings.clear();
    memory().remember(a, {WindowPlace{5, 6, 7, 8, true}, {}});
    EXPECT_EQ(memory().recall(a).window->width, 7);
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(Remembering, WhatCannotBeWrittenIsNoFailure) {
    put(folder / "not", "a file where a folder should be");
    const fs::path a = scene("a.toml");
    memory().remember(a, {WindowPlace{1, 2, 3, 4, false}, {}});
    EXPECT_EQ(warnings.size(), 1u);
    memory().add_opened(a);
    EXPECT_EQ(warnings.size(), 2u);
    EXPECT_FALSE(memory().recall(a).window);
    EXPECT_THAT(memory().opened(), IsEmpty());
    EXPECT_EQ(warnings.size(), 2u);
}

TEST_F(Remembering, OpenedScenesComeNewestFirst) {
    const fs::path a = scene("a.toml"), b = scene("b.toml"), c = scene("c.toml");
    for (const fs::path& file : {a, b, c, a}) memory().add_opened(file);
    EXPECT_THAT(memory().opened(), ElementsAre(a, c, b));
    memory().add_opened(folder / "." / "b.toml");
    EXPECT_THAT(memory().opened(), ElementsAre(b, a, c));
    fs::remove(a);
    EXPECT_THAT(memory().opened(), ElementsAre(b, c));
    std::vector<fs::path> many;
    for (int k = 0; k < 30; ++k) {
        many.insert(many.begin(), scene(fmt::format("{}.toml", k)));
        memory().add_opened(many.front());
    }
    many.resize(Memory::most_opened);
    EXPECT_EQ(memory().opened(), many);
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(Remembering, ABrokenHistoryBeginsAgain) {
    const fs::path a = scene("a.toml");
    memory().add_opened(a);
    for (const std::string broken :
         {"", "{\"version\": 1}", "{\"version\": 1, \"opened\": [3]}", "{\"opened\": []}"}) {
        put(state / "history.json", broken);
        warnings.clear();
        EXPECT_THAT(memory().opened(), IsEmpty());
        EXPECT_EQ(warnings.size(), 1u) << broken;
    }
    memory().add_opened(a);
    EXPECT_THAT(memory().opened(), ElementsAre(a));
}

TEST_F(Remembering, FileNamesThatAreNoTextDoNoHarm) {
    const fs::path odd = scene("\xff\xfe.toml"), a = scene("a.toml");
    memory().remember(odd, {WindowPlace{1, 2, 3, 4, false}, {}});
    EXPECT_TRUE(memory().recall(odd).window);
    memory().add_opened(a);
    memory().add_opened(odd);
    EXPECT_THAT(memory().opened(), ElementsAre(a));
    EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(Remembering, NeedsNoFolder) {
    const Memory none{fs::path()};
    const fs::path a = scene("a.toml");
    none.remember(a, {WindowPlace{1, 2, 3, 4, false}, {}});
    none.add_opened(a);
    EXPECT_FALSE(none.recall(a).window);
    EXPECT_THAT(none.opened(), IsEmpty());
}

TEST(StateFolder, FollowsTheSpecification) {
    const image::Environment home("HOME", "/she");
    {
        const image::Environment state("XDG_STATE_HOME", "/state");
        EXPECT_EQ(state_folder(), "/state/isomotion");
    }
    for (const char* ignored : {"", "relative/path"}) {
        const image::Environment state("XDG_STATE_HOME", ignored);
        EXPECT_EQ(state_folder(), "/she/.local/state/isomotion");
        const image::Environment nowhere("HOME", ignored);
        EXPECT_EQ(state_folder(), "");
    }
}

TEST(WindowPlaces, AreWithinAScreen) {
    const std::vector<WorkArea> areas{{0, 20, 1920, 1060}, {1920, 0, 1280, 1024}};
    const WindowPlace fits{100, 50, 800, 600};
    EXPECT_EQ(within(fits, areas), fits);
    EXPECT_EQ(within({1900, 50, 800, 600}, areas), (WindowPlace{1920, 50, 800, 600}));
    EXPECT_EQ(within({5000, -9000, 800, 600}, areas), (WindowPlace{1120, 20, 800, 600}));
    EXPECT_EQ(within({2000, 100, 65536, 65536}, areas).height, 1024);
    EXPECT_EQ(within({-65536, 0, 65536, 65536, true}, areas),
              (WindowPlace{0, 20, 1920, 1060, true}));
    EXPECT_EQ(within(fits, {}), fits) << "nothing is known of screens";
}

} // namespace
} // namespace isomotion::player::memory_test
