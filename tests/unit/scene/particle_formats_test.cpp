// Every format of particles gives the numbers that were written, whatever the file is called; what
// is cut off or wrong is an error or right, and never more.
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "particle_writers.h"
#include "scene/error.h"
#include "scene/limits.h"
#include "scene/particles/read_particles.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

using particles::Cloud;
using particles::Vtu;
using testing::HasSubstr;
using testing::StartsWith;

using Columns = std::map<std::string, std::vector<double>>;

struct Read {
    std::string format;
    std::size_t count = 0;
    Columns columns;
    std::vector<std::int64_t> ids;
};

Read read_all(const std::filesystem::path& file, const std::string& bytes,
              std::size_t most = 1000) {
    ParticleRequest request;
    request.file = file;
    request.choose = [&](const std::string&, const std::vector<std::string>& names) {
        return Wanted{std::vector<bool>(names.size(), true), most, 1e6};
    };
    ParticleTable table = read_particles(request, bytes, 1 << 20).table;
    Read read{table.format, table.count, {}, {}};
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const std::string& name = table.columns[k].name;
        if (name == "id") {
            read.ids = take_whole_numbers(table, file, k);
        } else {
            read.columns[name] = take_numbers(table, file, k);
        }
    }
    return read;
}

Columns expected(const Cloud& cloud) {
    Columns columns;
    for (std::size_t k = 0; k < cloud.count(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            columns[std::string(1, "xyz"[c])].push_back(double(cloud.position[k][c]));
            columns[std::string("v") + "xyz"[c]].push_back(double(cloud.velocity[k][c]));
        }
        columns["mass"].push_back(double(cloud.mass[k]));
    }
    return columns;
}

class ParticleFormats : public Scenes {
protected:
    std::filesystem::path write_bytes(const std::string& name, std::string_view bytes) const {
        const std::filesystem::path file = folder() / name;
        std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
        return file;
    }
    static std::string wrong(const std::string& name, const std::string& bytes) {
        try {
            read_all(name, bytes);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "nothing is wrong";
    }
    // What is there is exact; what may be missing are whole columns.
    static void expect_right(const Read& read, const Cloud& cloud, const std::string& where) {
        const Columns all = expected(cloud);
        ASSERT_EQ(read.count, cloud.count()) << where;
        for (const auto& [name, numbers] : read.columns) {
            if (all.contains(name)) {
                EXPECT_EQ(numbers, all.at(name)) << where << " " << name;
            }
        }
        if (!read.ids.empty()) {
            EXPECT_EQ(read.ids, std::vector<std::int64_t>(cloud.id.begin(), cloud.id.end()));
        }
    }
};

TEST_F(ParticleFormats, GiveTheNumbersThatWereWritten) {
    for (const int count : {1, 2, 5, 100}) {
        const Cloud cloud = particles::cloud(count, unsigned(count));
        for (const particles::Sample& sample : particles::samples(cloud)) {
            const Read read = read_all(sample.file, sample.bytes);
            expect_right(read, cloud, sample.name);
            for (const char* axis : {"x", "y", "z"})
                EXPECT_TRUE(read.columns.contains(axis)) << sample.name;
            EXPECT_EQ(read.columns.contains("vz"), sample.name != "Xyz") << sample.name;
            const bool has_more = sample.name.find("Rows") == std::string::npos &&
                                  sample.name != "NpyColumnsBig" && sample.name != "Xyz";
            EXPECT_EQ(read.columns.contains("mass"), has_more) << sample.name;
            EXPECT_EQ(read.ids.size(), has_more ? cloud.count() : 0) << sample.name;
        }
    }
}

TEST_F(ParticleFormats, OfNoParticlesAreRead) {
    const Cloud none;
    for (const particles::Sample& sample : particles::samples(none)) {
        const Read read = read_all(sample.file, sample.bytes);
        EXPECT_EQ(read.count, 0u) << sample.name;
    }
}

TEST_F(ParticleFormats, SayHowManyTheyHoldByTheirBeginning) {
    const Cloud cloud = particles::cloud(4000, 3);
    for (const particles::Sample& sample : particles::samples(cloud)) {
        const auto file = write_bytes(sample.file, sample.bytes);
        std::size_t left = 1 << 22;
        EXPECT_EQ(count_particles(file, {}, 1 << 22, left), 4000u) << sample.name;
        EXPECT_LE(left, std::size_t(1 << 22)) << sample.name;
        std::size_t little = 1;
        count_particles(file, {}, 1 << 22, little);
        EXPECT_EQ(little == 0, left < std::size_t(1 << 22)) << sample.name << " is read whole";
        EXPECT_EQ(read_all(file, sample.bytes, 4000).count, 4000u) << sample.name;
    }
}

TEST_F(ParticleFormats, CutOffAreMistakesOrRight) {
    const Cloud cloud = particles::cloud(3, 8);
    for (const particles::Sample& sample : particles::samples(cloud)) {
        int read_well = 0;
        for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
            const std::string where = fmt::format("{} cut off at {}", sample.name, size);
            try {
                const Read read = read_all(sample.file, sample.bytes.substr(0, size));
                ++read_well;
                // The last number of a text may be cut; the beginning of what tells a format may be
                // the header of a table.
                if (!sample.is_text && size < std::string_view("# vtk DataFile").size()) {
                    EXPECT_EQ(read.count, 0u) << where;
                } else if (!sample.is_text) {
                    expect_right(read, cloud, where);
                }
            } catch (const SceneError& error) {
                EXPECT_THAT(error.what(), StartsWith(sample.file + ":")) << where;
            }
        }
        // Most of what is cut off shows.
        if (!sample.is_text) {
            EXPECT_LT(read_well, int(sample.bytes.size() / 2)) << sample.name;
        }
    }
}

TEST_F(ParticleFormats, DamagedNeverCrash) {
    const unsigned seed = 20;
    std::mt19937 random(seed);
    const Cloud cloud = particles::cloud(3, 9);
    for (const particles::Sample& sample : particles::samples(cloud)) {
        for (int k = 0; k < 400; ++k) {
            std::string bytes = sample.bytes;
            for (unsigned n = 1 + random() % 3; n > 0; --n)
                bytes[random() % bytes.size()] = char(random() % 4 ? random() : 0xff);
            try {
                for (const auto& [name, numbers] : read_all(sample.file, bytes).columns) {
                    for (const double number : numbers)
                        EXPECT_TRUE(std::isfinite(number)) << sample.name << " seed " << seed;
                }
            } catch (const SceneError&) {
            }
        }
    }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == text.npos) throw std::logic_error("not there: " + from);
    return text.replace(at, from.size(), to);
}

// None of them asks for memory that it then cannot fill.
TEST_F(ParticleFormats, CountsThatLieAreMistakes) {
    const Cloud cloud = particles::cloud(3, 1);
    const std::string many = "3000000000000000000", tenfold = "10000000";
    for (const std::string& count : {many, tenfold, std::string("1001")}) {
        const std::string says =
            fmt::format("says that it holds {} particles; there may be 1000", count);
        for (const char* format : {"ascii", "binary_little_endian"}) {
            EXPECT_EQ(
                wrong("p", replaced(particles::ply(cloud, format), "vertex 3", "vertex " + count)),
                "p: " + says);
        }
        EXPECT_EQ(wrong("p", replaced(particles::npy_rows(cloud, true, true), "(3, 6)",
                                      fmt::format("({}, 6)", count))),
                  "p: " + says);
        EXPECT_EQ(wrong("p", replaced(particles::vtu(cloud, Vtu::appended_raw, true), "Points=\"3",
                                      "Points=\"" + count)),
                  "p: " + says);
        EXPECT_THAT(wrong("p", replaced(particles::vtk(cloud, false, false), "POINTS 3",
                                        "POINTS " + count)),
                    HasSubstr("belong here; the file has"));
        EXPECT_THAT(wrong("p.xyz", replaced(particles::xyz(cloud), "3\n", count + "\n")),
                    HasSubstr(says));
    }
    // Within what there may be, but not what the file has.
    EXPECT_THAT(
        wrong("p", replaced(particles::ply(cloud, "ascii"), "vertex 3", "vertex 900")),
        HasSubstr("p:14: the header says that there are 900 vertices of 9 numbers; the file "
                  "has "));
    EXPECT_THAT(
        wrong("p", replaced(particles::ply(cloud, "binary_big_endian"), "vertex 3", "vertex 4")),
        testing::MatchesRegex("p: byte [0-9]+: the file ends in its vertices: it has [0-9]+ bytes, "
                              "of 148 more that belong here"));
    EXPECT_THAT(
        wrong("p", replaced(particles::npy_records(cloud), "'shape': (3,)", "'shape': (9,)")),
        HasSubstr("the file ends in its numbers"));
    EXPECT_THAT(wrong("p", replaced(particles::vtu(cloud, Vtu::inline_base64, false), "Points=\"3",
                                    "Points=\"4")),
                HasSubstr("the array says that it has 36 bytes; 48 belong here"));
    EXPECT_THAT(wrong("p", replaced(particles::vtu(cloud, Vtu::appended_base64, true), "Points=\"3",
                                    "Points=\"900")),
                HasSubstr("the blocks say that they hold 36 bytes; 10800 belong here"));
    EXPECT_EQ(wrong("p.xyz", replaced(particles::xyz(cloud), "3\n", "4\n")),
              "p.xyz:6: the first line says that there are 4 particles; 3 are here");
    EXPECT_EQ(wrong("p.xyz", replaced(particles::xyz(cloud), "3\n", "2\n")),
              "p.xyz:5: follows the 2 particles that the file has so far; those of another time "
              "begin with their count");
    std::string bytes = particles::bgeo(cloud);
    bytes[9] = 0x7f;
    EXPECT_EQ(wrong("p", bytes), "p: says that it holds 2130706435 particles; there may be 1000");
    bytes[9] = char(0x80);
    EXPECT_EQ(wrong("p", bytes), "p: byte 9: the number of points is -2147483645, below 0");
}

TEST_F(ParticleFormats, NumbersThatAreNoneNameTheirParticle) {
    Cloud cloud = particles::cloud(3, 1);
    for (const float none : {std::nanf(""), HUGE_VALF, -HUGE_VALF}) {
        cloud.position[1][1] = none;
        for (const particles::Sample& sample : particles::samples(cloud)) {
            const std::string message = wrong(sample.file, sample.bytes);
            EXPECT_THAT(message, HasSubstr("is not a finite number")) << sample.name;
            EXPECT_THAT(message, HasSubstr(": y: ")) << sample.name;
            EXPECT_THAT(message, testing::AnyOf(HasSubstr(": particle 2: "),
                                                testing::ContainsRegex(":[0-9]+: ")))
                << sample.name;
        }
    }
    EXPECT_EQ(wrong("p", particles::bgeo(cloud)),
              "p: byte 166: particle 2: y: '-inf' is not a finite number");
}

TEST_F(ParticleFormats, IdsAreExact) {
    std::string npy = particles::npy_records(particles::cloud(1, 1));
    const std::int64_t large = 9'007'199'254'740'993; // no double holds it
    std::memcpy(npy.data() + npy.size() - 16 - 8, &large, 8);
    EXPECT_EQ(read_all("p", npy).ids, std::vector{large});
}

TEST_F(ParticleFormats, WhatIsNoneOfThemIsSaid) {
    EXPECT_THAT(wrong("p.bgeo", "\x7fNSJb..."), HasSubstr("is a BGEO of Houdini 12 or later"));
    EXPECT_THAT(wrong("p.npy", "PK\x03\x04..."), HasSubstr("numpy.save"));
    EXPECT_THAT(wrong("p.ply", std::string("\x01\x00\x02", 3)), HasSubstr("is no format that is"));
    EXPECT_THAT(wrong("p.vtu", "<?xml version=\"1.0\"?><svg/>"), HasSubstr("is XML, but no VTK"));
    EXPECT_THAT(wrong("p.vtk", "# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_GRID\n"),
                HasSubstr("p.vtk:4: the data set is 'STRUCTURED_GRID'"));
    EXPECT_THAT(wrong("p.gz", "\x1f\x8b..."), HasSubstr("packed data are damaged"));
    const std::string bomb = particles::gzip(std::string(3 << 20, 'x'));
    EXPECT_LT(bomb.size(), 10'000u);
    EXPECT_THAT(wrong("p.csv", bomb), HasSubstr("holds more than 1048576 bytes once it is unpack"));
}

TEST_F(ParticleFormats, NamesOfColumnsThatWereWrittenDifferently) {
    const std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                             "property float y\nproperty float z\nproperty uchar red\n"
                             "property uchar green\nproperty float blue\nproperty float x_0\n"
                             "end_header\n1 2 3 4 5 6 7\n";
    const Read read = read_all("p", text);
    for (const auto& [name, value] :
         {std::pair("x", 1.0), {"z", 3.0}, {"r", 4.0}, {"b", 6.0}, {"x_0", 7.0}})
        EXPECT_EQ(read.columns.at(name), std::vector{value}) << name;
    EXPECT_EQ(wrong("p", replaced(text, "float x_0", "float x")),
              "p: x: two columns have this name");
}

// From 0 to 1 whatever their type is, where all three are whole bytes or pairs of them.
TEST_F(ParticleFormats, ColoursOfWholeNumbersBecomeParts) {
    const auto ply = [](const std::string& format, const std::string& type) {
        return "ply\nformat " + format + " 1.0\nelement vertex 1\nproperty float x\nproperty " +
               type + " red\nproperty " + type + " green\nproperty " + type +
               " blue\nproperty uchar alpha\nproperty uchar n\nend_header\n";
    };
    const auto expect = [](const std::string& bytes, double r, double g, double b, double a) {
        const Columns columns = read_all("p", bytes).columns;
        for (const auto& [name, value] : {std::pair("r", r), {"g", g}, {"b", b}, {"a", a}})
            EXPECT_DOUBLE_EQ(columns.at(name).at(0), value) << name;
        EXPECT_EQ(columns.at("n").at(0), 255) << "no colour";
    };
    expect(ply("ascii", "uchar") + "1 0 51 255 102 255\n", 0, 0.2, 1, 0.4);
    expect(ply("ascii", "ushort") + "1 0 13107 65535 51 255\n", 0, 0.2, 1, 0.2);
    expect(ply("ascii", "float") + "1 0 0.25 1 51 255\n", 0, 0.25, 1, 51);
    expect(ply("ascii", "int") + "1 0 51 255 51 255\n", 0, 51, 255, 51);
    const std::string one("\0\0\x80\x3f", 4);
    expect(ply("binary_little_endian", "uchar") + one + std::string("\0\x33\xff\x66\xff", 5), 0,
           0.2, 1, 0.4);
    expect(ply("binary_little_endian", "ushort") + one +
               std::string("\0\0\x33\x33\xff\xff\x33\xff", 8),
           0, 0.2, 1, 0.2);
}

TEST_F(ParticleFormats, ColoursOfLegacyVtk) {
    const std::string begin = "# vtk DataFile Version 3.0\n\n";
    const std::string points = "DATASET POLYDATA\nPOINTS 1 float\n";
    const std::string values = "POINT_DATA 1\nCOLOR_SCALARS Cd 3\n";
    const auto parts = [](const std::string& bytes) {
        const Columns columns = read_all("p", bytes).columns;
        return std::vector{columns.at("r")[0], columns.at("g")[0], columns.at("b")[0]};
    };
    const std::vector<double> wanted{0, 0.2, 1};
    EXPECT_EQ(parts(begin + "ASCII\n" + points + "1 2 3\n" + values + "0 0.2 1\n"), wanted)
        << "as a text they are parts already";
    EXPECT_EQ(parts(begin + "BINARY\n" + points + std::string(12, '\0') + "\n" + values +
                    std::string("\0\x33\xff\n", 4)),
              wanted);
    EXPECT_EQ(parts(begin + "ASCII\n" + points + "1 2 3\nPOINT_DATA 1\nFIELD f 1\n" +
                    "rgb 3 1 unsigned_char\n0 51 255\n"),
              wanted);
}

} // namespace
} // namespace isomotion::scene
