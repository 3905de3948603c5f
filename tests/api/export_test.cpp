#include <filesystem>
#include <fstream>
#include <set>

#include "api/error_code.h"

namespace isomotion {
namespace {

namespace fs = std::filesystem;

class ExportFrames : public testing::Test {
protected:
    ExportFrames() {
        folder_ = fs::temp_directory_path() / "isomotion_api_export_test";
        fs::remove_all(folder_);
        settings_.output = (folder_ / "ball.####.png").string();
    }
    ~ExportFrames() override { fs::remove_all(folder_); }

    static Scene scene() {
        return Scene::parse("[time]\nframes = 6\n[surface]\nformula = 'x^2 + y^2 + z^2 - r'\n"
                            "bounds = { sphere = 2 }\n[parameters]\nr = '1 + t'\n"
                            "[output]\nsize = [32, 32]\n");
    }
    static Device& device() {
        static Device device;
        return device;
    }

    fs::path folder_;
    ExportSettings settings_;
};

TEST_F(ExportFrames, AreWholeResumedAndVerified) {
    std::set<std::string> told_files;
    double part = 0;
    const ExportWatcher watcher{.progress = [&](const ExportProgress& now) {
        told_files.insert(now.file.string());
        EXPECT_EQ(now.count, 6);
        EXPECT_EQ(now.done, now.frame - 1);
        EXPECT_GE(now.done + now.part, part);
        part = now.done + now.part;
    }};
    const Exported first = export_frames(device(), scene(), settings_, watcher);
    EXPECT_EQ(first.drawn, 6);
    EXPECT_GT(first.hits, 0);
    EXPECT_EQ(first.wrong, 0);
    EXPECT_GT(first.audited, 0);
    EXPECT_FALSE(first.stopped);
    EXPECT_EQ(told_files.size(), 6u);
    EXPECT_EQ(part, 6);
    EXPECT_EQ(first.rays(), 6 * 32 * 32);
    EXPECT_GE(first.evaluations(), first.rays() - first.misses);
    EXPECT_NE(first.summary(1).find("drawn 6 in "), std::string::npos) << first.summary(1);
    const fs::path manifest = folder_ / "ball.manifest";
    EXPECT_TRUE(verify(manifest, true).whole);

    settings_.resume = true;
    fs::remove(folder_ / "ball.0004.png");
    EXPECT_EQ(verify(manifest).missing, std::vector{4});
    const Exported again = export_frames(device(), scene(), settings_);
    EXPECT_EQ(again.drawn, 1);
    EXPECT_EQ(again.kept, 5);
    ASSERT_EQ(again.not_kept.size(), 1u);
    EXPECT_EQ(again.not_kept[0].why, "missing");
    EXPECT_EQ(again.not_kept[0].frames, std::vector{4});
    EXPECT_NE(again.summary(1).find("not kept: 1 missing (4)\n"), std::string::npos);
    EXPECT_TRUE(verify(manifest).whole);
    std::ofstream(folder_ / "ball.0002.png", std::ios::app) << "more";
    EXPECT_EQ(verify(manifest).changed, std::vector{2});
}

TEST_F(ExportFrames, OfAPart) {
    settings_.frames = {2, 4, 6};
    settings_.audit = 0;
    const Exported part = export_frames(device(), scene(), settings_);
    EXPECT_EQ(part.drawn, 3);
    EXPECT_EQ(part.audited, 0);
    EXPECT_FALSE(fs::exists(folder_ / "ball.0003.png"));
    EXPECT_TRUE(verify(folder_ / "ball.manifest").whole);
    settings_.frames = {3};
    settings_.part_of = {2, 3, 4, 6};
    export_frames(device(), scene(), settings_);
    EXPECT_TRUE(verify(folder_ / "ball.manifest").whole);
    settings_.part_of = {2, 3, 4, 5, 6};
    export_frames(device(), scene(), settings_);
    EXPECT_EQ(verify(folder_ / "ball.manifest").missing, std::vector{5});
}

TEST_F(ExportFrames, InSteps) {
    settings_.movies = {folder_ / "ball.gif"};
    Exporter exporter(scene(), settings_);
    EXPECT_EQ(exporter.frames(), (std::vector{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(exporter.output(), settings_.output);
    EXPECT_FALSE(fs::exists(folder_));
    exporter.prepare();
    EXPECT_TRUE(fs::exists(folder_));
    const std::string plan = exporter.plan(device());
    EXPECT_NE(plan.find(": 6 frames, 32x32, "), std::string::npos) << plan;
    EXPECT_EQ(exporter.write_frames(device()).drawn, 6);
    EXPECT_FALSE(exporter.write_movies([] { return true; }));
    EXPECT_TRUE(exporter.write_movies());
    EXPECT_TRUE(fs::exists(folder_ / "ball.gif"));
}

TEST_F(ExportFrames, WarnOfWhatShowsNothing) {
    std::string warnings;
    const ExportWatcher watcher{
        .warn = [&](const std::string& words) { warnings += words + "\n"; }};
    settings_.frames = {1};
    export_frames(device(), scene().with("r", -1), settings_, watcher);
    EXPECT_NE(warnings.find("no ray hits anything"), std::string::npos) << warnings;
}

TEST_F(ExportFrames, CanBeStopped) {
    int asked = 0;
    const Exported part =
        export_frames(device(), scene(), settings_, {.stop = [&] { return ++asked > 4; }});
    EXPECT_TRUE(part.stopped);
    EXPECT_LT(part.drawn, 6);
    EXPECT_FALSE(verify(folder_ / "ball.manifest").whole);
}

// The table of the elements has the name of a frame.
TEST_F(ExportFrames, DoNotReplaceWhatTheyAreMadeFrom) {
    fs::create_directories(folder_);
    const fs::path table = folder_ / "ball.0003.png";
    const char* written = "x,y\n0,0\n";
    std::ofstream(table) << written;
    std::ofstream(folder_ / "scene.toml")
        << "[surface]\nformula = '1 - sum(blobs, exp(-(x-x0)^2 - y^2 - z^2))'\n"
           "bounds = { sphere = 2 }\n[time]\nframes = 6\n[arrays.blobs]\n"
           "file = 'ball.0003.png'\ncolumns = { x0 = 'x' }\n";
    const Told told_of_scene = told([&] {
        export_frames(device(), Scene::load((folder_ / "scene.toml").string()), settings_);
    });
    EXPECT_EQ(told_of_scene.code, Error::Code::setting) << told_of_scene.words;
    EXPECT_TRUE(told_of_scene.words.starts_with("output ")) << told_of_scene.words;
    std::ifstream text(table);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(text), {}), written);
}

TEST_F(ExportFrames, TellMistakes) {
    const auto code = [&] {
        return told([&] { export_frames(device(), scene(), settings_); }).code;
    };
    settings_.bits = 12;
    EXPECT_EQ(code(), Error::Code::setting);
    settings_.bits = 8;
    settings_.audit = -1;
    EXPECT_EQ(code(), Error::Code::setting);
    settings_.audit = {};
    settings_.frames = {0};
    EXPECT_EQ(code(), Error::Code::input);
    settings_.frames = {2};
    settings_.part_of = {1};
    EXPECT_EQ(code(), Error::Code::setting);
    settings_.frames = settings_.part_of = {};
    settings_.channels = {"z"}; // a PNG has none
    EXPECT_EQ(code(), Error::Code::setting);
    settings_.channels = {};
    settings_.output = (folder_ / "ball.####.gif").string();
    EXPECT_EQ(code(), Error::Code::input);
    EXPECT_EQ(told([&] { verify(folder_ / "none.manifest"); }).code, Error::Code::file);
}

} // namespace
} // namespace isomotion
