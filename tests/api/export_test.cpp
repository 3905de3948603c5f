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
    const Watcher watcher{
        .progress = [&](const std::string& file, double) { told_files.insert(file); }};
    const Exported first = export_frames(device(), scene(), settings_, watcher);
    EXPECT_EQ(first.drawn, 6);
    EXPECT_GT(first.hits, 0);
    EXPECT_EQ(first.wrong, 0);
    EXPECT_GT(first.audited, 0);
    EXPECT_FALSE(first.stopped);
    EXPECT_EQ(told_files.size(), 6u);
    const fs::path manifest = folder_ / "ball.manifest";
    EXPECT_TRUE(verify(manifest, true).whole);

    settings_.resume = true;
    fs::remove(folder_ / "ball.0004.png");
    EXPECT_EQ(verify(manifest).missing, std::vector{4});
    const Exported again = export_frames(device(), scene(), settings_);
    EXPECT_EQ(again.drawn, 1);
    EXPECT_EQ(again.kept, 5);
    EXPECT_TRUE(verify(manifest).whole);
    std::ofstream(folder_ / "ball.0002.png", std::ios::app) << "more";
    EXPECT_EQ(verify(manifest).changed, std::vector{2});
}

TEST_F(ExportFrames, OfAPart) {
    settings_.frames = "2-6x2";
    settings_.audit = 0;
    const Exported part = export_frames(device(), scene(), settings_);
    EXPECT_EQ(part.drawn, 3);
    EXPECT_EQ(part.audited, 0);
    EXPECT_FALSE(fs::exists(folder_ / "ball.0003.png"));
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
           "file = 'ball.0003.png'\nformat = 'csv'\ncolumns = { x0 = 'x' }\n";
    const Told told_of_scene = told([&] {
        export_frames(device(), Scene::load((folder_ / "scene.toml").string()), settings_);
    });
    EXPECT_EQ(told_of_scene.code, Error::Code::input) << told_of_scene.words;
    std::ifstream text(table);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(text), {}), written);
}

TEST_F(ExportFrames, TellMistakes) {
    const auto code = [&] {
        return told([&] { export_frames(device(), scene(), settings_); }).code;
    };
    settings_.bits = 12;
    EXPECT_EQ(code(), Error::Code::input);
    settings_.bits = 8;
    settings_.audit = -1;
    EXPECT_EQ(code(), Error::Code::input);
    settings_.audit = {};
    settings_.frames = "1-";
    EXPECT_EQ(code(), Error::Code::input);
    settings_.frames = "";
    settings_.channels = {"z"}; // a PNG has none
    EXPECT_EQ(code(), Error::Code::input);
    settings_.channels = {};
    settings_.output = (folder_ / "ball.####.gif").string();
    EXPECT_EQ(code(), Error::Code::input);
    EXPECT_EQ(told([&] { verify(folder_ / "none.manifest"); }).code, Error::Code::file);
}

} // namespace
} // namespace isomotion
