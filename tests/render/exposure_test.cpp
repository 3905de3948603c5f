// Frames that are means of pictures, against the integrals they stand for.
#include "render/exposure.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/drawing.h"

namespace isomotion::render {
namespace {

class Exposure : public Drawing {
protected:
    Picture exposed(const scene::Scene& scene, int frame = 1) {
        return expose(*renderer(scene), scene, frame);
    }
    std::string print(const scene::Scene& scene, int frame = 1) {
        return renderer(scene)->prepare(scene, frame).fingerprint;
    }
    std::unique_ptr<Renderer> renderer(const scene::Scene& scene) {
        return std::make_unique<Renderer>(
            *context, scene,
            RenderOptions{scene.output.width, scene.output.height, every_channel, {}});
    }
};
ISOMOTION_ON_EVERY_BACKEND(Exposure);

float sample(const Picture& picture, const char* channel, int column, int row) {
    const image::Frame& f = picture.frame;
    return f.find(channel)->samples[std::size_t(row * f.width + column)];
}

// A plane, ball or what `formula` says, seen along -x: columns run along y, rows down along -z, and
// a pixel is 1/8 wide. `c` is a parameter that may move. Coverage is the channel A.
std::string flat(const std::string& formula, const std::string& camera = "",
                 const std::string& c = "") {
    return fmt::format(R"(
[time]
fps = 10
frames = 20
[surface]
formula = "{}"
bounds = {{ box = [[-3, -3, -3], [3, 3, 3]] }}
{}
[isolation]
step = 0.02
[camera]
position = [5, 0, 0]
target = [0, 0, 0]
projection = "orthographic"
height = 4
{}
[output]
size = [32, 32]
background = "transparent"
)",
                       formula, c.empty() ? "" : fmt::format("[parameters]\nc = \"{}\"", c),
                       camera);
}

double y_of(double column) { return (column - 16) / 8; }

// The part of [low, high] that a disc covers on the line at height z.
double chord(double low, double high, double z, double centre, double radius) {
    const double square = radius * radius - z * z;
    if (square <= 0) return 0;
    const double half = std::sqrt(square);
    return std::max(0.0, std::min(high, centre + half) - std::max(low, centre - half)) /
           (high - low);
}

TEST_P(Exposure, OneSampleIsThePictureBitForBit) {
    for (const char* camera : {"", "shutter = 0.5", "aperture = 0.5\nfocus = 2"}) {
        const scene::Scene scene =
            scene_of(flat("(y - c)^2 + x^2 + z^2 - 1", camera, "t") + "samples = 1\n");
        const Picture plain = draw(*context, scene, 3), one = exposed(scene, 3);
        EXPECT_TRUE(same_bits(plain.frame, one.frame));
        EXPECT_EQ(plain.evaluations(), one.evaluations());
        const auto drawer = renderer(scene);
        EXPECT_EQ(drawer->prepare(scene, 3).pictures.size(), 1u);
        EXPECT_EQ(print(scene, 3), drawer->prepare(scene, 3).fingerprint);
    }
}

TEST_P(Exposure, DataIsThatOfTheFirstPictureAndTheRecordThatOfAll) {
    const scene::Scene scene = scene_of(
        flat("(y - c)^2 + x^2 + z^2 - 1", "shutter = 1\naperture = 0.5", "t") + "samples = 7\n");
    const Picture plain = draw(*context, scene, 3), mean = exposed(scene, 3);
    std::int64_t rays = 0;
    for (const auto n : mean.verdicts) rays += n;
    EXPECT_EQ(rays, 7 * 32 * 32);
    EXPECT_GT(mean.evaluations(), 6 * plain.evaluations());
    for (std::size_t c = 0; c < plain.frame.channels.size(); ++c) {
        const auto &a = plain.frame.channels[c], &b = mean.frame.channels[c];
        ASSERT_EQ(a.name, b.name);
        EXPECT_EQ(a.samples == b.samples, c >= 4) << a.name;
    }
}

// A plane across the picture: every ray sees one colour, and so does their mean.
TEST_P(Exposure, AFlatRegionKeepsItsColour) {
    for (const int count : {2, 7, 64}) {
        const scene::Scene scene = scene_of(flat("x", "") + fmt::format("samples = {}\n", count));
        EXPECT_TRUE(same_bits(draw(*context, scene).frame, exposed(scene).frame)) << count;
    }
}

// The edge y = slope*z + c covers a pixel by a polygon; here by a trapezium, wherever it crosses
// the pixel from top to bottom.
TEST_P(Exposure, AnEdgeCoversItsPartOfAPixel) {
    const double slope = 0.3, offset = 0.0371;
    double before = 1;
    for (const int count : {1, 16, 256}) {
        const scene::Scene scene =
            scene_of(flat(fmt::format("max(x, y - {}*z - {})", slope, offset)) +
                     fmt::format("samples = {}\n", count));
        const Picture picture = exposed(scene);
        double worst = 0;
        for (int row = 0; row < 32; ++row) {
            for (int column = 0; column < 32; ++column) {
                double covered = 0;
                constexpr int strips = 1000;
                for (int k = 0; k < strips; ++k) {
                    const double z = -y_of(row + (k + 0.5) / strips);
                    covered += std::clamp(8 * (slope * z + offset - y_of(column)), 0.0, 1.0);
                }
                worst = std::max(
                    worst, std::abs(covered / strips - double(sample(picture, "A", column, row))));
            }
        }
        if (count > 1) {
            EXPECT_LT(worst, 1.5 * std::pow(count, -0.75)) << count;
        }
        EXPECT_LT(worst, before);
        before = worst;
    }
}

// Pixel by pixel the mean over the pixel and the shutter is the integral of the disc's coverage.
TEST_P(Exposure, AMovingBallIsBlurredAsFarAsItMoves) {
    const double speed = 8, shutter = 0.75, radius = 0.6;
    const scene::Scene scene =
        scene_of(flat(fmt::format("x^2 + (y - c)^2 + z^2 - {}", radius * radius),
                      fmt::format("shutter = {}", shutter), fmt::format("{}*(t - 0.2)", speed)) +
                 "samples = 256\n");
    const Picture picture = exposed(scene, 3); // t = 0.2 s to 0.275 s
    double most = 0;
    for (int row = 0; row < 32; ++row) {
        for (int column = 0; column < 32; ++column) {
            double covered = 0;
            constexpr int strips = 100;
            for (int k = 0; k < strips * strips; ++k) {
                const double z = y_of(row + (k % strips + 0.5) / strips);
                const double centre = speed * shutter / 10 * (k / strips + 0.5) / strips;
                covered += chord(y_of(column), y_of(column + 1), z, centre, radius);
            }
            covered /= strips * strips;
            const double error = std::abs(covered - double(sample(picture, "A", column, row)));
            EXPECT_LT(error, 0.03) << column << "," << row;
            most = std::max(most, error);
        }
    }
    RecordProperty("worst", fmt::format("{}", most));
    EXPECT_EQ(sample(picture, "A", 19, 16), 1) << "covered all the time";
}

// Seen through a lens of diameter d focused at f, a point at depth z is a disc of diameter
// d |z - f| / f where it is (parallel rays), and sharp in focus.
TEST_P(Exposure, ABallIsAsWideAsItsCircleOfConfusion) {
    const double radius = 0.2, aperture = 4;
    for (const double focus : {5.0, 4.0, 7.0}) {
        const scene::Scene scene =
            scene_of(flat(fmt::format("x^2 + y^2 + z^2 - {}", radius * radius),
                          fmt::format("aperture = {}\nfocus = {}", aperture, focus)) +
                     "samples = 256\n");
        const Picture picture = exposed(scene);
        const double blur = aperture / 2 * std::abs(5 - focus) / focus;
        double area = 0, second = 0;
        for (int row = 0; row < 32; ++row) {
            for (int column = 0; column < 32; ++column) {
                const double y = y_of(column + 0.5), z = y_of(row + 0.5);
                const double a = double(sample(picture, "A", column, row));
                area += a / 64;
                second += a / 64 * (y * y + z * z);
                // Half a pixel's diagonal is 0.0884; a slanted ray widens the ball by up to 12
                // percent.
                if (std::hypot(y, z) > blur + 1.2 * radius + 0.09) {
                    EXPECT_EQ(a, 0) << y << "," << z;
                }
            }
        }
        // Across a ray that leans by an angle the ball is a disc, on the picture wider by the
        // angle's secant: in the mean over the lens by this.
        const double lean = aperture / 2 / focus;
        const double wider = 2.0 / 3 * (std::pow(1 + lean * lean, 1.5) - 1) / (lean * lean);
        EXPECT_NEAR(area / (M_PI * radius * radius), wider, 0.02) << focus;
        // Blur adds its own second moment to the ball's and the pixel's.
        const double expected = (blur * blur + radius * radius) / 2 + 2.0 / 12 / 64;
        EXPECT_NEAR(second / area, expected, 0.1 * expected) << focus;
    }
}

TEST_P(Exposure, TheFingerprintIsOfAllThePictures) {
    const auto moving = [](const std::string& camera, int samples) {
        return scene_of(flat("(y - c)^2 + x^2 + z^2 - 1", camera, "max(0, t - 0.15)") +
                        fmt::format("samples = {}\n", samples));
    };
    const scene::Scene plain = moving("", 1), open = moving("shutter = 1", 8);
    EXPECT_EQ(print(plain, 1), print(plain, 2));
    // Both frames begin alike, but in the second's time the ball sets off.
    EXPECT_NE(print(open, 1), print(open, 2));
    EXPECT_EQ(print(moving("shutter = 0.4", 8), 1), print(moving("shutter = 0.4", 8), 2));
    EXPECT_NE(print(moving("", 8), 1), print(moving("", 9), 1));
    EXPECT_NE(print(moving("", 8), 1), print(plain, 1));
    EXPECT_NE(print(moving("aperture = 1", 8), 1), print(moving("aperture = 2", 8), 1));
    EXPECT_NE(print(moving("aperture = 1", 8), 1), print(moving("aperture = 1\nfocus = 4", 8), 1));
}

TEST_P(Exposure, AValueThatLeavesItsRangeInTheShuttersTimeIsAMistake) {
    const scene::Scene scene =
        scene_of(flat("x^2 + y^2 + z^2 - 1", "zoom = \"0.05 - t\"\nshutter = 1"));
    EXPECT_NO_THROW(scene::at_frame(scene, 1));
    EXPECT_THROW(check_exposure(scene, 1), scene::SceneError);
    EXPECT_THROW(exposed(scene), scene::SceneError);
}

} // namespace
} // namespace isomotion::render
