// A file for each frame.
#include <random>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "animation/element_samples.h"
#include "base/fingerprint.h"
#include "particle_writers.h"
#include "scene/limits.h"
#include "scene/particles/file_frames.h"
#include "scene/source_print.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

using particles::Cloud;
using testing::ElementsAre;
using testing::HasSubstr;

class ParticleFrames : public Scenes {
protected:
    void write_bytes(const std::string& name, std::string_view bytes) const {
        std::filesystem::create_directories((folder() / name).parent_path());
        std::ofstream(folder() / name, std::ios::binary)
            .write(bytes.data(), std::streamsize(bytes.size()));
    }
    // [arrays.p] is line 8, `array` begins with line 9.
    static std::string scene_of(const std::string& array, int frames = 3) {
        return fmt::format("[time]\nfps = 10\nframes = {}\n[surface]\n"
                           "formula = \"sum(p, exp(-(x-cx)^2 - (y-cy)^2 - (z-cz)^2)) - 0.5\"\n"
                           "bounds = {{ sphere = 4 }}\n\n[arrays.p]\n{}\n"
                           "columns = {{ cx = \"x\", cy = \"y\", cz = \"z\" }}\n",
                           frames, array);
    }
    static formula::ArrayColumns<double> at_frame(const Scene& scene, int frame) {
        return scene.surfaces[0].animation.at(scene.timeline.time(frame)).arrays[0];
    }
    static const FileFrames& source_of(const Scene& scene) {
        return dynamic_cast<const FileFrames&>(
            scene.surfaces[0].animation.arrays()[0].samples->source());
    }
    std::string print_of(const Scene& scene) const {
        base::Fingerprint print;
        scene::add_array(print, scene.surfaces[0].animation, 0);
        return print.text();
    }
};

Cloud one(float x, float vx, int id) { return {{{x, 0, 0}}, {{vx, 0, 0}}, {id}, {1}}; }

std::vector<double> xs(const Cloud& cloud) {
    std::vector<double> numbers;
    for (const auto& v : cloud.position) numbers.push_back(double(v[0]));
    return numbers;
}

// Links of one text, whose lines can only be counted by reading all of it each time.
TEST_F(ParticleFrames, AreReadToCountThemWithinABudget) {
    constexpr std::size_t length = 64 << 20;
    constexpr int frames = int(limits::counted_bytes / length) + 1;
    write_bytes("all.csv", "x,y,z\n0,0,0\n" + std::string(length, '\n'));
    for (int k = 1; k <= frames; ++k)
        std::filesystem::create_symlink("all.csv", folder() / fmt::format("p.{}.csv", k));
    const std::string file = "file = \"p.#.csv\"";
    EXPECT_THAT(mistake(scene_of(file, frames)),
                AllOf(HasSubstr("p.9.csv: more than 536870912 bytes"),
                      HasSubstr("give the array a count, the most that a file holds")));
}

TEST_F(ParticleFrames, OfEveryFormatWithCountsThatChange) {
    const auto clouds = {particles::cloud(3, 1), particles::cloud(7, 2), Cloud(),
                         particles::cloud(1, 3)};
    const std::size_t formats = particles::samples(Cloud()).size();
    for (std::size_t f = 0; f < formats; ++f) {
        std::string name;
        int frame = 0;
        for (const Cloud& cloud : clouds) {
            const particles::Sample sample = particles::samples(cloud)[f];
            std::string extension = sample.file.substr(1);
            name = fmt::format("{}/p.####{}", sample.name, extension);
            write_bytes(fmt::format("{}/p.{:04}{}", sample.name, ++frame, extension), sample.bytes);
        }
        const Scene scene = loaded(scene_of(fmt::format("file = \"{}\"", name), 4));
        EXPECT_EQ(scene.surfaces[0].animation.arrays()[0].count, 7) << name;
        for (const int k : {2, 4, 1, 3}) {
            const auto columns = at_frame(scene, k);
            const auto expected = xs(std::data(clouds)[k - 1]);
            ASSERT_EQ(columns.count, int(expected.size())) << name;
            EXPECT_EQ(columns.fields[0], expected) << name << " frame " << k;
        }
    }
}

// Frame k alone is frame k of the sequence, in whatever order they come and whatever is in memory.
TEST_F(ParticleFrames, AreAPureFunctionOfTime) {
    constexpr int frames = 30;
    for (int k = 1; k <= frames; ++k)
        write_bytes(fmt::format("p.{:03}.ply", k),
                    particles::ply(particles::cloud(k % 5, unsigned(k)), "binary_big_endian"));
    const std::string text = scene_of("file = \"p.###.ply\"", frames);
    std::vector<formula::ArrayColumns<double>> in_order;
    const Scene scene = loaded(text);
    for (int k = 1; k <= 3 * frames - 2; ++k) {
        in_order.push_back(scene.surfaces[0].animation.at((k - 1) / 30.0).arrays[0]);
        EXPECT_LE(source_of(scene).frames_now(), 6u);
    }
    // Each once, but for a few before the first frame was asked for.
    EXPECT_LE(source_of(scene).files_read(), std::size_t(frames + 25));
    const unsigned seed = 5;
    std::mt19937 random(seed);
    const Scene other = loaded(text);
    for (int k = 0; k < 200; ++k) {
        const std::size_t any = random() % in_order.size();
        EXPECT_EQ(other.surfaces[0].animation.at(double(any) / 30).arrays[0], in_order[any])
            << "seed " << seed;
        EXPECT_LE(source_of(other).frames_now(), 6u);
    }
}

TEST_F(ParticleFrames, FromManyThreads) {
    for (int k = 1; k <= 12; ++k)
        write_bytes(fmt::format("p.{}.bgeo", k), particles::bgeo(particles::cloud(9, unsigned(k))));
    const Scene scene = loaded(scene_of("file = \"p.#.bgeo\"", 12));
    std::vector<std::jthread> threads;
    for (unsigned seed = 0; seed < 4; ++seed) {
        threads.emplace_back([&, seed] {
            std::mt19937 random(seed);
            for (int k = 0; k < 60; ++k) {
                const int frame = 1 + int(random() % 12);
                EXPECT_EQ(at_frame(scene, frame).fields[0],
                          xs(particles::cloud(9, unsigned(frame))));
            }
        });
    }
}

TEST_F(ParticleFrames, MoveWhereTheirIdsAreNext) {
    const Cloud first{{{0, 0, 0}, {10, 0, 0}, {20, 0, 0}}, {{}, {}, {}}, {5, 6, 7}, {1, 1, 1}};
    const Cloud second{{{24, 0, 0}, {4, 0, 0}}, {{}, {}}, {7, 5}, {1, 1}};
    write_bytes("p1.bgeo", particles::bgeo(first));
    write_bytes("p2.bgeo", particles::gzip(particles::bgeo(second)));
    const std::string files = "file = \"p#.bgeo\"\ninterpolation = ";
    const Scene scene = loaded(scene_of(files + "\"linear\"", 2));
    EXPECT_THAT(scene.surfaces[0].animation.at(scene.timeline.time(1, 0.5)).arrays[0].fields[0],
                ElementsAre(2, 10, 22));
    EXPECT_THAT(at_frame(scene, 2).fields[0], ElementsAre(24, 4));
    const Scene held = loaded(scene_of(files + "\"hold\"", 2));
    EXPECT_THAT(held.surfaces[0].animation.at(held.timeline.time(1, 0.5)).arrays[0].fields[0],
                ElementsAre(0, 10, 20));
}

TEST_F(ParticleFrames, FollowTheirVelocities) {
    write_bytes("p1.bgeo", particles::bgeo(one(0, 10, 1)));
    write_bytes("p2.bgeo", particles::bgeo(one(1, -10, 1)));
    const Scene scene = loaded(scene_of("file = \"p#.bgeo\"", 2));
    // Hermite over a tenth of a second: 1/2 + (1 + 1) / 8.
    EXPECT_NEAR(scene.surfaces[0].animation.at(scene.timeline.time(1, 0.5)).arrays[0].fields[0][0],
                0.75, 1e-12);
    const Scene straight = loaded(scene_of("file = \"p#.bgeo\"\ninterpolation = \"linear\"", 2));
    EXPECT_NEAR(
        straight.surfaces[0].animation.at(straight.timeline.time(1, 0.5)).arrays[0].fields[0][0],
        0.5, 1e-12);
    write_bytes("q1.xyz", particles::xyz(one(0, 0, 1)));
    EXPECT_EQ(mistake(scene_of("file = \"q#.xyz\"\ninterpolation = \"hermite\"", 1)),
              "q1.xyz: vx: there is no column vx, vy or vz beside x, y or z; interpolation = "
              "\"hermite\" reads them");
}

TEST_F(ParticleFrames, MayBeginAtAnyNumberAndBeEvenlyApart) {
    for (const int number : {0, 4, 8})
        write_bytes(fmt::format("p.{:04}.bgeo", number), particles::bgeo(one(float(number), 0, 1)));
    const std::string file = "file = \"p.%04d.bgeo\"\ninterpolation = \"linear\"\n";
    const Scene scene = loaded(scene_of(file + "first_file = 0", 9));
    for (int frame = 1; frame <= 9; ++frame)
        EXPECT_NEAR(at_frame(scene, frame).fields[0][0], frame - 1, 1e-12);
    EXPECT_EQ(mistake(scene_of(file, 9)),
              "p.0008.bgeo: ends at t = 0.7, but frame 9 of the scene is at t = 0.8; lower "
              "time.frames, or give the array extrapolate = \"hold\", or first_file = the number "
              "of the file of frame 1");
    const Scene held = loaded(scene_of(file + "extrapolate = \"hold\"", 50));
    EXPECT_THAT(at_frame(held, 50).fields[0], ElementsAre(8));
}

TEST_F(ParticleFrames, MistakesNameTheFile) {
    for (const int number : {1, 2, 4})
        write_bytes(fmt::format("p.{}.ply", number), particles::ply(one(1, 0, 1), "ascii"));
    const std::string file = "file = \"p.#.ply\"";
    EXPECT_EQ(mistake(scene_of(file)),
              "scene.toml:9: arrays.p.file: there is no file p.3.ply, between p.2.ply and p.4.ply");
    EXPECT_EQ(mistake(scene_of("file = \"q.#.ply\"")),
              "scene.toml:9: arrays.p.file: there is no file q.#.ply, with a number in place of "
              "####");
    EXPECT_THAT(mistake(scene_of("file = \"none/q.#.ply\"")), HasSubstr("none cannot be read"));
    EXPECT_THAT(mistake(scene_of("file = \"q.#.#.ply\"")), HasSubstr("two places"));
    EXPECT_EQ(mistake(scene_of("file = \"p.1.ply\"\nfirst_file = 0")),
              "scene.toml:10: arrays.p.first_file: is the number of the file that frame 1 shows; "
              "the file's name has no place for one, such as ####");

    // What is wrong in a later file is said when that is shown.
    Cloud wrong = one(1, 0, 1);
    wrong.position[0][2] = std::nanf("");
    write_bytes("p.3.ply", particles::ply(wrong, "ascii"));
    // Scenes look at some frames when they are read; not at the files of those that follow.
    const auto said = [&](const std::string& array, int frame) {
        std::string message = "nothing is wrong";
        try {
            const Scene scene = loaded(scene_of(array, 1));
            scene.surfaces[0].animation.at(scene.timeline.time(frame));
        } catch (const SceneError& error) {
            message = error.what();
        }
        return message.substr(message.rfind('/') + 1);
    };
    EXPECT_EQ(said(file, 3), "p.3.ply:15: z: 'nan' is not a finite number");
    EXPECT_EQ(said(file, 2), "nothing is wrong");
    write_bytes("p.3.ply", particles::npy_rows(one(1, 0, 1), false, false));
    EXPECT_EQ(said(file, 3), "nothing is wrong"); // nothing reads the mass that it lacks
    write_bytes("p.3.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                           "property float y\nend_header\n1 2\n");
    EXPECT_EQ(said(file, 3), "p.3.ply: z: there is no such column; p.1.ply has it");
    Cloud twins = particles::cloud(3, 1);
    twins.id = {4, 5, 4};
    write_bytes("p.3.ply", particles::ply(twins, "binary_little_endian"));
    EXPECT_THAT(said(file, 3), HasSubstr("particle 3: id: 4 is that of particle 1 already"));
    EXPECT_EQ(said(file + "\ncount = 2", 3),
              "p.3.ply: says that it holds 3 particles; there may be 2");
    write_bytes("p.3.ply", "ply\nformat ascii 1.0\nelement vertex 10000000\nproperty float x\n"
                           "end_header\n");
    EXPECT_EQ(mistake(scene_of(file)),
              "p.3.ply: says that it holds 10000000 particles; there may be 1000000");
    std::filesystem::remove(folder() / "p.3.ply");
    std::filesystem::create_directory(folder() / "p.3.ply");
    EXPECT_THAT(mistake(scene_of(file)), HasSubstr("arrays.p.file: there is no file"));
}

TEST_F(ParticleFrames, MayNotLieElsewhere) {
    for (const int number : {1, 2})
        write_bytes(fmt::format("scenes/p.{}.bgeo", number), particles::bgeo(one(1, 0, 1)));
    write_bytes("p.3.bgeo", particles::bgeo(one(1, 0, 1)));
    const auto load_it = [&](const std::string& name) {
        const auto file = write("scenes/scene.toml", scene_of("file = \"" + name + "\"", 1));
        std::string message = "nothing is wrong";
        try {
            load(file.string());
        } catch (const SceneError& error) {
            message = error.what();
        }
        return message;
    };
    EXPECT_EQ(load_it("p.#.bgeo"), "nothing is wrong");
    EXPECT_THAT(load_it("../p.#.bgeo"), HasSubstr("lies outside the scene's folder"));
    std::filesystem::create_symlink(folder() / "p.3.bgeo", folder() / "scenes" / "p.3.bgeo");
    EXPECT_THAT(load_it("p.#.bgeo"), HasSubstr("lies outside the scene's folder"));
}

TEST_F(ParticleFrames, HaveAnotherFingerprintWhereAnyOfThemHasAnotherByte) {
    for (const int number : {1, 2, 3})
        write_bytes(fmt::format("p.{}.bgeo", number),
                    particles::bgeo(particles::cloud(40, unsigned(number))));
    const std::string text = scene_of("file = \"p.#.bgeo\"");
    const std::string before = print_of(loaded(text));
    EXPECT_EQ(print_of(loaded(text)), before);
    std::string bytes = particles::bgeo(particles::cloud(40, 2));
    bytes[bytes.size() / 2] ^= 1;
    write_bytes("p.2.bgeo", bytes);
    EXPECT_NE(print_of(loaded(text)), before);
}

// Frames drawn before and after would pass for one simulation's.
TEST_F(ParticleFrames, AreRefusedWhereTheyChangedAfterTheSceneWasRead) {
    const auto write_all = [&](const char* row) {
        for (int k = 1; k <= 9; ++k)
            write_bytes(fmt::format("p.{}.csv", k), fmt::format("x,y,z\n{},0,0\n", row));
    };
    write_all("1");
    const Scene scene = loaded(scene_of("file = \"p.#.csv\"", 9));
    write_all("12");
    int refused = 0; // not those that are still in memory
    for (int frame = 1; frame <= 9; ++frame) {
        try {
            EXPECT_EQ(at_frame(scene, frame).fields[0][0], 1) << frame;
        } catch (const SceneError& error) {
            EXPECT_THAT(error.what(), HasSubstr(".csv: changed after the scene was read"));
            ++refused;
        }
    }
    EXPECT_GE(refused, 3);
    // Also when nothing reads them again.
    const auto& samples = *scene.surfaces[0].animation.arrays()[0].samples;
    EXPECT_THROW(samples.source().expect_unchanged(), SceneError);
    const Scene again = loaded(scene_of("file = \"p.#.csv\"", 9));
    EXPECT_NO_THROW(again.surfaces[0].animation.arrays()[0].samples->source().expect_unchanged());
}

TEST_F(ParticleFrames, SayWhereTheyAreFrom) {
    for (const int number : {1, 2, 3})
        write_bytes(fmt::format("p.{}.bgeo", number), particles::bgeo(one(1, 0, 1)));
    const Scene scene = loaded(scene_of("file = \"p.#.bgeo\""));
    EXPECT_EQ(source_of(scene).origin(1),
              (folder() / "p.2.bgeo").string() + ": BGEO; 3 files, p.1.bgeo to p.3.bgeo");
    EXPECT_THAT(source_of(scene).names(),
                testing::UnorderedElementsAre("x", "y", "z", "vx", "vy", "vz", "id", "mass"));
}

// One file of another format, standing still or with all times.
TEST_F(ParticleFrames, OneFileOfAnyFormat) {
    const Cloud cloud = particles::cloud(5, 1);
    for (const particles::Sample& sample : particles::samples(cloud)) {
        write_bytes(sample.file, sample.bytes);
        const Scene scene = loaded(scene_of("file = \"" + sample.file + "\""));
        for (const int frame : {1, 3})
            EXPECT_EQ(at_frame(scene, frame).fields[0], xs(cloud)) << sample.name;
        EXPECT_THAT(mistake(scene_of("count = 4\nfile = \"" + sample.file + "\"")),
                    testing::AnyOf(HasSubstr("particles; there may be 4"),
                                   HasSubstr("is element 5 of its time; the array's count")))
            << sample.name;
    }
    write("d.csv", "time,x,y,z\n0,1,0,0\n0.1,2,0,0\n0.2,3,0,0\n");
    const Scene scene = loaded(scene_of("file = \"d.csv\""));
    EXPECT_THAT(at_frame(scene, 2).fields[0], ElementsAre(2));
}

} // namespace
} // namespace isomotion::scene
