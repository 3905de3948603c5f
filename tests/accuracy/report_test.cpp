// Reports in every form, of measurements made by hand.
#include "accuracy/report.h"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "image/decode.h"
#include "unit/image/places.h"

namespace isomotion::accuracy {
namespace {

using testing::HasSubstr;

Report two_settings() {
    Report report;
    report.title = "A <title> & more";
    report.machine = "a machine";
    report.isolation.bisections = 10;
    report.frames = {3};
    report.width = 3;
    report.height = 2;
    for (const double step : {0.1, 0.05}) {
        Measurement m;
        m.setting = {scene::Method::amp_sign, step, 1, 10};
        m.ms = 1 / step;
        m.evaluations = 600;
        m.errors.pixels = m.errors.rays = 6;
        m.errors.faults = {Fault::none,       Fault::missed,    Fault::false_hit,
                           Fault::wrong_root, Fault::undecided, Fault::none};
        m.errors.missed = step > 0.07;
        m.errors.depth = {0.25f};
        report.measurements.push_back(m);
    }
    return report;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Report, TableMarksTheFront) {
    Report report = two_settings();
    EXPECT_THAT(table(report), HasSubstr("* amp-sign step=0.1 "));
    EXPECT_THAT(table(report), HasSubstr("* amp-sign step=0.05 "));
    report.measurements[0].errors.missed = 0;
    EXPECT_THAT(table(report), HasSubstr("  amp-sign step=0.05 "));
}

TEST(Report, CsvAndJsonSayTheSame) {
    const Report report = two_settings();
    EXPECT_THAT(csv(report),
                HasSubstr("\namp-sign,0.1,1,10,32,10.0000,0.0000,100.000,16666.667,6,6,"
                          "1,0,0,166666.667,0.25,0.25,0.25,0,0,0,0,0,0,0\n"));
    const auto parsed = nlohmann::json::parse(json(report));
    EXPECT_EQ(parsed["version"], 1);
    EXPECT_EQ(parsed["scene"], report.title);
    ASSERT_EQ(parsed["measurements"].size(), 2u);
    EXPECT_EQ(parsed["measurements"][0]["missed"], 1);
    EXPECT_EQ(parsed["measurements"][0]["depth"]["p99"], 0.25);
    EXPECT_TRUE(parsed["measurements"][1]["front"]);
}

TEST(Report, FolderHoldsAllOfIt) {
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "gnuplot is not installed";
    }
    const image::TemporaryFolder folder;
    const auto place = folder / "it's a report";
    write(two_settings(), place);
    for (const char* name : {"accuracy.csv", "accuracy.json", "accuracy.svg", "accuracy.png",
                             "wrong-01.png", "wrong-02.png", "index.html"}) {
        EXPECT_TRUE(std::filesystem::exists(place / name)) << name;
    }
    const image::Frame wrong = image::decode(place / "wrong-01.png");
    ASSERT_EQ(wrong.width, 3);
    const auto colour = [&](std::size_t pixel) {
        return std::array{wrong.find("R")->samples[pixel], wrong.find("B")->samples[pixel]};
    };
    EXPECT_EQ(colour(0), colour(5));
    EXPECT_GT(colour(1)[0], 2 * colour(1)[1]); // missed: red
    EXPECT_LT(2 * colour(2)[0], colour(2)[1]); // false hit: blue
    const std::string page = text_of(place / "index.html");
    EXPECT_THAT(page, HasSubstr("A &lt;title> &amp; more"));
    EXPECT_THAT(page, HasSubstr("<svg"));
    EXPECT_THAT(page, HasSubstr("data:image/png;base64,iVBOR"));
    // By itself: nothing is loaded from elsewhere.
    EXPECT_THAT(page, testing::Not(HasSubstr("src=\"wrong")));
    EXPECT_THAT(page, testing::Not(HasSubstr("href=\"accuracy")));
}

TEST(Report, WithoutGnuplotSaysWhatToInstall) {
    const image::TemporaryFolder folder;
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder.path().c_str(), 1);
    EXPECT_THROW(write(two_settings(), folder / "r"), Error);
    setenv("PATH", path.c_str(), 1);
    EXPECT_TRUE(std::filesystem::exists(folder / "r" / "accuracy.csv"));
}

} // namespace
} // namespace isomotion::accuracy
