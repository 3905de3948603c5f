// Arrays from files of comma-separated values, and what is said about wrong ones.
#include <fmt/format.h>

#include "scene/reading/element_table.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

using testing::ElementsAre;

class ElementTables : public Scenes {
protected:
    // A sum over drops with fields cx, cy, cz; [arrays.drops] is line 8, `array` begins with 9.
    static std::string drops(const std::string& array = "", int frames = 3) {
        return fmt::format("[time]\nfps = 10\nframes = {}\n[surface]\n"
                           "formula = \"sum(drops, exp(-(x-cx)^2 - (y-cy)^2 - (z-cz)^2)) - 0.5\"\n"
                           "bounds = {{ sphere = 4 }}\n\n[arrays.drops]\nfile = \"d.csv\"\n{}\n",
                           frames, array);
    }
    Scene read(const std::string& table, const std::string& array = "", int frames = 3) const {
        write("d.csv", table);
        return loaded(drops(array, frames));
    }
    std::string wrong(const std::string& table, const std::string& array = "",
                      int frames = 3) const {
        write("d.csv", table);
        return mistake(drops(array, frames));
    }
    static formula::ArrayColumns<double> at_frame(const Scene& scene, int frame) {
        return scene.surfaces[0].animation.at(scene.timeline.time(frame)).arrays[0];
    }
};

TEST_F(ElementTables, StandStillWithoutATime) {
    const Scene scene = read("cx,cy,cz\n1,2,3\n4,5,6\n");
    for (const int frame : {1, 3}) {
        const auto columns = at_frame(scene, frame);
        EXPECT_EQ(columns.count, 2);
        EXPECT_THAT(columns.fields[0], ElementsAre(1, 4));
        EXPECT_THAT(columns.fields[2], ElementsAre(3, 6));
    }
    EXPECT_EQ(scene.surfaces[0].animation.arrays()[0].count, 2);
}

// What is read once must be whole for each of those that read it.
TEST_F(ElementTables, SeveralArraysReadOneFileEachInItsWay) {
    write("d.csv", "frame,id,x,cy,vx\n1,5,1,10,30\n1,6,2,20,30\n2,6,4,40,30\n3,6,8,80,30\n");
    const auto array = [](const char* name, const char* more) {
        return fmt::format("[arrays.{}]\nfile = \"d.csv\"\n{}\n", name, more);
    };
    const std::string text =
        array("a", "interpolation = \"linear\"") +
        array("b", "columns = { cx = \"x\", again = \"x\" }\ninterpolation = \"hold\"") +
        array("c", "columns = { who = \"id\", when = \"frame\", cx = \"x\" }") +
        array("d", "interpolation = \"linear\"") +
        "[time]\nfps = 10\nframes = 3\n[surface]\nbounds = { sphere = 4 }\nformula = ";
    const Scene scene = loaded(text + "\"x + sum(a, cy) + sum(b, cx + cy + again) + "
                                      "sum(c, who + when + cx) + sum(d, cy)\"");
    const auto field = [&](std::size_t a, const std::string& name, double t) {
        const auto& fields = scene.surfaces[0].animation.arrays()[a].fields;
        const auto at = std::ranges::find(fields, name, &animation::ArrayField::name);
        return scene.surfaces[0].animation.at(t).arrays[a].fields[std::size_t(at - fields.begin())];
    };
    for (const std::size_t a : {0u, 3u}) {
        EXPECT_THAT(field(a, "cy", 0), ElementsAre(10, 20));
        EXPECT_THAT(field(a, "cy", 0.15), ElementsAre(testing::DoubleNear(60, 1e-9)));
    }
    EXPECT_THAT(field(1, "cx", 0.05), ElementsAre(1, 2));
    EXPECT_THAT(field(1, "again", 0.05), ElementsAre(1, 2));
    EXPECT_THAT(field(1, "cy", 0.15), ElementsAre(40));
    EXPECT_THAT(field(2, "who", 0), ElementsAre(5, 6));
    EXPECT_THAT(field(2, "when", 0), ElementsAre(1, 1));
    // On a cubic from 4 to 8, at both ends as fast as 30.
    EXPECT_THAT(field(2, "cx", 0.15), ElementsAre(testing::DoubleNear(6, 1e-9)));
    EXPECT_THAT(field(2, "cx", 0.125),
                ElementsAre(testing::DoubleNear(4 + 4 * 0.15625 + 3 * 0.09375, 1e-9)));
    // The mistake is that of one.
    EXPECT_EQ(mistake(array("e", "count = 1") + text + "\"x + sum(a, cy) + sum(e, cy)\""),
              "d.csv:3: is element 2 of its time; the array's count allows 1");
}

TEST_F(ElementTables, TakeOffTheBudgetWhatIsKept) {
    const auto left = [&](const std::string& table, std::size_t arrays, double values) {
        TableOptions options;
        options.file = write("d.csv", table);
        options.most = 10;
        std::vector<TableOptions> all(arrays, options);
        for (std::size_t k = 0; k < arrays; ++k) all[k].columns[fmt::format("c{}", k)] = "x";
        TableBudget budget{1000, values};
        const auto read = read_element_tables(all, animation::Timeline(), budget);
        EXPECT_EQ(read.size(), arrays);
        EXPECT_EQ(budget.bytes, 1000 - table.size()) << "of " << arrays;
        return budget.values;
    };
    // Rows of x; of x and its time; of x, its time and its id.
    EXPECT_EQ(left("x\n1\n2\n", 1, 100), 98);
    EXPECT_EQ(left("frame,x\n1,1\n2,2\n", 1, 100), 96);
    EXPECT_EQ(left("id,x\n1,1\n2,2\n", 1, 100), 96);
    EXPECT_EQ(left("frame,id,x\n1,1,1\n1,2,2\n", 1, 100), 94);
    for (const std::size_t arrays : {2u, 5u})
        EXPECT_EQ(left("frame,id,x\n1,1,1\n1,2,2\n", arrays, 100), 100 - 6 * double(arrays));
    EXPECT_EQ(left("frame,id,x\n1,1,1\n1,2,2\n", 2, 12), 0);
    EXPECT_THAT([&] { left("frame,id,x\n1,1,1\n1,2,2\n", 2, 11); },
                testing::ThrowsMessage<SceneError>(testing::HasSubstr(
                    "d.csv:1: has 2 lines, and 12 numbers of them are kept; all tables of a scene "
                    "hold at most 3e+07")));
}

TEST_F(ElementTables, FramesAreThoseOfTheScene) {
    const Scene scene = read("frame,cx,cy,cz\n1,0,0,0\n2,5,0,0\n2,6,0,0\n3,7,0,0\n");
    EXPECT_THAT(at_frame(scene, 1).fields[0], ElementsAre(0));
    EXPECT_THAT(at_frame(scene, 2).fields[0], ElementsAre(5, 6));
    EXPECT_THAT(at_frame(scene, 3).fields[0], ElementsAre(7));
    EXPECT_EQ(scene.surfaces[0].animation.arrays()[0].count, 2); // the most there are
    // Exactly so at any rate of frames.
    write("d.csv", "frame,cx,cy,cz\n1,0,0,0\n500,5,0,0\n999,6,0,0\n");
    const Scene odd = loaded(drops("", 999), {"time.fps=\"30000/1001\""});
    EXPECT_THAT(at_frame(odd, 500).fields[0], ElementsAre(5));
    EXPECT_THAT(at_frame(odd, 999).fields[0], ElementsAre(6));
}

TEST_F(ElementTables, SecondsMayBeUneven) {
    const Scene scene = read("t,cx,cy,cz\n0,0,0,0\n0.15,3,0,0\n7,0,0,0\n");
    EXPECT_NEAR(at_frame(scene, 2).fields[0][0], 2, 1e-12);
}

TEST_F(ElementTables, EveryFourthFrameIsEnough) {
    const Scene scene = read("frame,cx,cy,cz\n1,0,0,0\n5,4,0,0\n", "", 5);
    for (int frame = 1; frame <= 5; ++frame) {
        EXPECT_NEAR(at_frame(scene, frame).fields[0][0], frame - 1, 1e-12);
    }
}

TEST_F(ElementTables, ALineWithTheTimeAloneIsNoElement) {
    const Scene scene = read("frame,cx,cy,cz\n1,0,0,0\n2,,,\n3,1,0,0\n");
    EXPECT_EQ(at_frame(scene, 1).count, 1);
    EXPECT_EQ(at_frame(scene, 2).count, 0);
    EXPECT_EQ(at_frame(scene, 3).count, 1);
}

TEST_F(ElementTables, ColumnsCanBeCalledDifferently) {
    const Scene scene = read("x,\"y, m\",z,Points:0,mass\n1,2,3,4,5\n",
                             "columns = { cx = \"x\", cy = \"y, m\", cz = \"z\" }");
    const auto& fields = scene.surfaces[0].animation.arrays()[0].fields;
    ASSERT_EQ(fields.size(), 4u); // and mass; Points:0 is no name a formula could say
    EXPECT_EQ(fields[1].name, "cy");
    EXPECT_THAT(at_frame(scene, 1).fields[1], ElementsAre(2));
}

TEST_F(ElementTables, OneColumnCanBeTwoFields) {
    const Scene scene = read("a,b\n1,2\n", "columns = { cx = \"a\", cy = \"a\", cz = \"b\" }");
    EXPECT_THAT(at_frame(scene, 1).fields[0], ElementsAre(1));
    EXPECT_THAT(at_frame(scene, 1).fields[1], ElementsAre(1));
}

TEST_F(ElementTables, ExpressionsMayNameColumnsAndTheirNumber) {
    const Scene scene =
        read("frame,px,cy,cz\n1,1,0,0\n1,2,0,0\n2,3,0,0\n3,4,0,0\n", "cx = \"10*px + n + t\"");
    const auto column = [&](int frame) {
        const auto& fields = scene.surfaces[0].animation.arrays()[0].fields;
        for (std::size_t k = 0; k < fields.size(); ++k) {
            if (fields[k].name == "cx") return at_frame(scene, frame).fields[k];
        }
        return std::vector<double>{};
    };
    EXPECT_THAT(column(1), ElementsAre(12, 22));
    EXPECT_THAT(column(2), ElementsAre(31.1));
}

TEST_F(ElementTables, AreReadAsOtherProgramsWriteThem) {
    const auto expect = [&](const std::string& table) {
        EXPECT_THAT(at_frame(read(table), 1).fields[1], ElementsAre(-2, 2.5e-3)) << table;
    };
    expect("cx,cy,cz\n1,-2,3\n1,2.5e-3,3\n");
    expect("\xEF\xBB\xBF"
           "cx,cy,cz\r\n1,-2,3\r\n1,2.5e-3,3\r\n");
    expect("# made by a program\n\n cx , cy , cz \n 1 ,\t-2 , 3\n\n# more\n1,+2.5E-03,3");
    expect("\"cx\",\"cy\",\"cz\"\n1,-2.,3\n1,.0025,3\n");
}

TEST_F(ElementTables, TakeThePlaceOfTheCataloguesLists) {
    surface("two", "formula = \"sum(drops, exp(-(x-cx)^2 - y^2 - z^2)) - 0.5\"\n"
                   "bounds = { sphere = 4 }\n[arrays.drops]\ncount = 2\ncx = \"2*ux\"\n"
                   "ux = [1, 2]\n");
    write("d.csv", "ux\n5\n6\n7\n");
    const std::string use = "[surface]\nuse = \"two\"\n";
    EXPECT_EQ(at_frame(loaded(use), 1).count, 2);
    const Scene scene = loaded(use + "[arrays.drops]\nfile = \"d.csv\"\n");
    EXPECT_EQ(at_frame(scene, 1).count, 3);
    EXPECT_THAT(at_frame(scene, 1).fields, testing::Contains(ElementsAre(10, 12, 14)));
    EXPECT_THAT(mistake(use + "[arrays.drops]\nfile = \"d.csv\"\nux = [1, 2]\n"),
                "scene.toml:5: arrays.drops.ux: a list beside a file: put it into the file, as a "
                "column, or write an expression");
}

TEST_F(ElementTables, MayBeSetOnTheCommandLine) {
    write("d.csv", "cx,cy,cz\n1,2,3\n");
    const auto other = write("e.csv", "cx,cy,cz\n7,2,3\n");
    const Scene scene = loaded(drops(), {fmt::format("arrays.drops.file=\"{}\"", other.string())});
    EXPECT_THAT(at_frame(scene, 1).fields[0], ElementsAre(7));
}

TEST_F(ElementTables, MistakesInTheFileNameItsLine) {
    const std::string head = "frame,cx,cy,cz\n";
    for (const auto& [table, message] : std::vector<Mistake>{
             {"", "d.csv:1: is empty; it needs a line of column names, then one element a line"},
             {"\n# nothing\n",
              "d.csv:2: is empty; it needs a line of column names, then one element a line"},
             {"cx,cy,cz\n\n", "d.csv:2: holds no element below its header"},
             {"cx,cy,cz", "d.csv:1: holds no element below its header"},
             {"cx,cy,cx\n1,2,3\n", "d.csv:1: cx: two columns have this name"},
             {"frame,t,cx,cy,cz\n1,0,0,0,0\n",
              "d.csv:1: t: the file has a column `frame` already; one of the two tells the time"},
             {head + "1,0,nan,0\n", "d.csv:2: cy: 'nan' is not a finite number"},
             {head + "1,0,inf,0\n", "d.csv:2: cy: 'inf' is not a finite number"},
             {head + "1,0,NaN,0\n", "d.csv:2: cy: 'NaN' is not a finite number"},
             {head + "1,0,1e999,0\n", "d.csv:2: cy: '1e999' is beyond the range of numbers"},
             {head + "1,0,2 m,0\n", "d.csv:2: cy: '2 m' is not a number"},
             {head + "1,0,0x10,0\n", "d.csv:2: cy: '0x10' is not a number"},
             {head + "1,0,+-1,0\n", "d.csv:2: cy: '+-1' is not a number"},
             {head + "1,0,,0\n", "d.csv:2: cy: the cell is empty; it needs a number"},
             {head + "1,0,0\n", "d.csv:2: has 3 cells; the header names 4 columns"},
             {head + "1,0,0,0,\n", "d.csv:2: has 5 cells; the header names 4 columns"},
             {head + "\n# one\n1.5,0,0,0\n", "d.csv:4: frame: '1.5' must be a whole number"},
             {head + "1,0,0,0\n2,0,0,0\n4,0,0,0\n",
              "d.csv:4: frame: frame 4 follows 2: frame 3 is missing; a frame without elements is "
              "a line with its number alone"},
             {head + "1,0,0,0\n5,0,0,0\n13,0,0,0\n",
              "d.csv:4: frame: frame 13 follows 5: frame 9 is missing; a frame without elements "
              "is a line with its number alone"},
             {head + "1,0,0,0\n5,0,0,0\n6,0,0,0\n",
              "d.csv:4: frame: frame 6 follows 5, but the frames before are 4 apart; uneven times "
              "go into a column `t`"},
             {head + "2,0,0,0\n1,0,0,0\n",
              "d.csv:3: frame: 1 comes after 2; rows must be in the order of time"},
             {"t,cx,cy,cz\n1,0,0,0\n0.5,0,0,0\n",
              "d.csv:3: t: 0.5 comes after 1; rows must be in the order of time"},
             {head + "1,,,\n1,0,0,0\n",
              "d.csv:3: line 2 says that there are no elements at this time"},
             {head + "1,0,0,0\n1,,,\n",
              "d.csv:3: the time alone says that there are no elements then, but line 2 is of the "
              "same time"},
             {"id,frame,cx,cy,cz\n7,1,0,0,0\n8,1,0,0,0\n7,1,0,0,0\n",
              "d.csv:4: id: 7 is in line 2 already, at the same time"},
             {"id,cx,cy,cz\n7.5,0,0,0\n", "d.csv:2: id: '7.5' must be a whole number"},
             {head + "2,0,0,0\n3,0,0,0\n",
              "d.csv:2: begins at t = 0.1, after the scene's first frame; begin at 0, or give the "
              "array extrapolate = \"hold\""},
             {head + "1,0,0,0\n2,0,0,0\n",
              "d.csv:3: ends at t = 0.1, but frame 3 of the scene is at t = 0.2; lower "
              "time.frames, or give the array extrapolate = \"hold\""},
         }) {
        EXPECT_EQ(wrong(table), message) << table;
    }
}

TEST_F(ElementTables, MistakesInTheSceneNameTheirKey) {
    const std::string table = "x,y,z\n1,2,3\n";
    EXPECT_EQ(wrong(table, "columns = { cx = \"X\", cy = \"y\", cz = \"z\" }"),
              "d.csv:1: X: there is no such column; did you mean 'x'?");
    EXPECT_EQ(wrong("px,py,mass\n1,2,3\n", "columns = { cx = \"mas\" }"),
              "d.csv:1: mas: there is no such column; did you mean 'mass'?");
    EXPECT_EQ(wrong(table, "columns = { cx = \"velocity\", cy = \"y\", cz = \"z\" }"),
              "d.csv:1: velocity: there is no such column; the file has x, y, z");
    EXPECT_EQ(wrong(table, "columns = { cx = 3 }"),
              "scene.toml:10: arrays.drops.columns.cx: must be a text in quotes");
    EXPECT_EQ(wrong(table, "columns = { y = \"y\" }"),
              "scene.toml:10: arrays.drops.columns.y: 'y' already has a meaning in formulas; "
              "choose another name");
    EXPECT_EQ(
        wrong("cx,cy,cz\n1,2,3\n", "interpolation = \"cubic\""),
        "scene.toml:10: arrays.drops.interpolation: must be linear, hold or hermite, not 'cubic'");
    EXPECT_EQ(
        wrong("cx,cy,cz\n1,2,3\n", "extrapolate = \"loop\""),
        "scene.toml:10: arrays.drops.extrapolate: must be hold: the first and the last elements "
        "stay, not 'loop'");
    EXPECT_EQ(wrong("cx,cy,cz\n1,2,3\n1,2,3\n", "count = 1"),
              "d.csv:3: is element 2 of its time; the array's count allows 1");
    EXPECT_THAT(wrong("x,y,z\n1,2,3\n"), testing::HasSubstr("scene.toml:5: surface.formula: "));
    std::filesystem::remove(folder() / "d.csv");
    EXPECT_THAT(mistake(drops()),
                testing::MatchesRegex("scene.toml:9: arrays.drops.file: there is no file .*d.csv"));
}

TEST_F(ElementTables, OutsideHoldsWhatTheEndsShow) {
    const Scene scene = read("frame,cx,cy,cz\n2,5,0,0\n3,6,0,0\n", "extrapolate = \"hold\"", 9);
    EXPECT_THAT(at_frame(scene, 1).fields[0], ElementsAre(5));
    EXPECT_THAT(at_frame(scene, 9).fields[0], ElementsAre(6));
}

} // namespace
} // namespace isomotion::scene
