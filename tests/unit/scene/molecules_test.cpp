// Atoms of XYZ and PDB: their elements' radii and colours, and the times that one file holds.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "scene/particles/chemical_elements.h"
#include "scene/srgb.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;

TEST(ChemicalElements, AreKnownBySymbolsLabelsAndNumbers) {
    for (int k = 1; k <= chemical_elements; ++k) {
        EXPECT_EQ(atomic_number(chemical_element(k).symbol), k);
        EXPECT_EQ(atomic_number(fmt::format("{}", k)), k);
    }
    for (const auto& [symbol, number] :
         {std::pair{"C", 6}, {"c", 6},    {"CA", 20}, {"Ca", 20},  {"cl", 17}, {"C12", 6},
          {"H3'", 1},        {"Na+", 11}, {"O2-", 8}, {"D", 1},    {"T", 1},   {"Og", 118},
          {"", 0},           {"X", 0},    {"Xx", 0},  {"drop", 0}, {"0", 0},   {"119", 0},
          {"-6", 0},         {"C.ar", 0}, {"12C", 0}})
        EXPECT_EQ(atomic_number(symbol), number) << symbol;
}

// What chemists agree on: metals are larger than what is right of them in their period, and all
// radii are within what van der Waals' are.
TEST(ChemicalElements, HaveRadiiInOrder) {
    for (int k = 0; k <= chemical_elements; ++k) {
        EXPECT_GE(chemical_element(k).radius, 1.1) << k;
        EXPECT_LE(chemical_element(k).radius, 3.5) << k;
    }
    const auto radius = [](const char* symbol) {
        return chemical_element(atomic_number(symbol)).radius;
    };
    for (const auto& [larger, smaller] : {std::pair{"C", "N"},
                                          {"N", "O"},
                                          {"O", "F"},
                                          {"Na", "Mg"},
                                          {"K", "Ca"},
                                          {"Cs", "Ba"},
                                          {"I", "Br"},
                                          {"Br", "Cl"},
                                          {"Cl", "F"},
                                          {"Cs", "Rb"},
                                          {"Rb", "K"},
                                          {"K", "Na"}})
        EXPECT_GT(radius(larger), radius(smaller)) << larger << " " << smaller;
    EXPECT_EQ(radius("H"), 1.1);
    EXPECT_EQ(radius("C"), 1.7);
}

class Molecules : public Scenes {
protected:
    static std::string atoms_of(const std::string& file, int frames, const std::string& more = "") {
        return fmt::format(
            "[time]\nfps = 1\nframes = {}\n[surface]\nbounds = {{ sphere = 9 }}\n"
            "formula = \"least(atoms, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2) - radius) "
            "+ sum(atoms, 1e-9*(r + g + b + atomic_number{}))\"\n[arrays.atoms]\nfile = "
            "\"{}\"\ncolumns = {{ cx = \"x\", cy = \"y\", cz = \"z\" }}\n",
            frames, more, file);
    }
    Scene read(const std::string& file, const std::string& text, int frames = 1,
               const std::string& more = "") const {
        write(file, text);
        return loaded(atoms_of(file, frames, more));
    }
    std::string wrong(const std::string& file, const std::string& text, int frames = 1) const {
        write(file, text);
        return mistake(atoms_of(file, frames));
    }
    static std::vector<double> field(const Scene& scene, const std::string& name, int frame = 1) {
        const auto& fields = scene.surfaces[0].animation.arrays()[0].fields;
        const auto at = std::size_t(std::ranges::find(fields, name, &animation::ArrayField::name) -
                                    fields.begin());
        const auto values =
            scene.surfaces[0].animation.at(scene.timeline.time(frame)).arrays[0].fields.at(at);
        return {values.begin(), values.end()};
    }
};

TEST_F(Molecules, HaveRadiiAndColoursOfTheirElements) {
    const Scene scene = read("m.xyz", "3\nwater\nO 0 0 0.1\nh 0 0.7 -0.4\n1 0 -0.7 -0.4\n");
    EXPECT_THAT(field(scene, "radius"), ElementsAre(1.52, 1.1, 1.1));
    EXPECT_THAT(field(scene, "atomic_number"), ElementsAre(8, 1, 1));
    EXPECT_THAT(field(scene, "cy"), ElementsAre(0, 0.7, -0.7));
    const double dark = to_linear(13.0 / 255);
    EXPECT_THAT(field(scene, "r"), ElementsAre(1, 1, 1));
    EXPECT_THAT(field(scene, "g"), ElementsAre(DoubleNear(dark, 1e-12), 1, 1));
}

TEST_F(Molecules, OfNoElementAreDrawnToo) {
    const Scene scene = read("m.xyz", "2\n\nC 0 0 0\nXx 1 0 0\n");
    EXPECT_THAT(field(scene, "atomic_number"), ElementsAre(6, 0));
    EXPECT_THAT(field(scene, "radius"), ElementsAre(1.7, 1.5));
}

TEST_F(Molecules, MayComeFromOtherSystems) {
    const Scene scene = read("m.xyz", "\xEF\xBB\xBF 2 \r\n\r\nC\t0 0 0 \r\nO 1.5e0 0 0\r\n\r\n", 1);
    EXPECT_THAT(field(scene, "cx"), ElementsAre(0, 1.5));
    EXPECT_THAT(field(scene, "atomic_number"), ElementsAre(6, 8));
}

TEST_F(Molecules, MayBeginWithAnAtomOfNoElementOrWithANumber) {
    EXPECT_THAT(field(read("m.xyz", "2\n\nX 0 0 0\nC 1 0 0\n"), "atomic_number"),
                ElementsAre(0, 6));
    const Scene scene = read("m.xyz", "2\n\n6 0 0 0 0.1\n8 1.5 0 0 0.2\n");
    EXPECT_THAT(field(scene, "atomic_number"), ElementsAre(6, 8));
    EXPECT_THAT(field(scene, "cx"), ElementsAre(0, 1.5));
}

// What the file or the scene says goes before what elements are known for.
TEST_F(Molecules, KeepTheColumnsAndParametersThatHaveTheSameNames) {
    const Scene stated = read("m.xyz", "1\nProperties=element:S:1:pos:R:3:radius:R:1\nC 0 0 0 7\n");
    EXPECT_THAT(field(stated, "radius"), ElementsAre(7));
    EXPECT_THAT(field(stated, "atomic_number"), ElementsAre(6));
    write("m.xyz", "1\n\nC 0 0 0\n");
    EXPECT_EQ(
        mistake("[surface]\nbounds = { sphere = 2 }\n"
                "formula = \"1 - sum(atoms, exp(1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/r^2))\"\n"
                "[parameters]\nr = 0.5\n[arrays.atoms]\nfile = \"m.xyz\"\n"
                "columns = { cx = \"x\", cy = \"y\", cz = \"z\" }\n"),
        "nothing is wrong");
}

TEST_F(Molecules, OfSeveralFramesHaveTheTimesOfFrames) {
    const std::string frame = "1\nProperties=species:S:1:pos:R:3:frame:I:1:t:R:1\nC 0 0 0 7 8\n";
    EXPECT_THAT(field(read("m.xyz", frame + frame, 2), "cx", 2), ElementsAre(0));
}

// Labels that are no elements are labels: such files have no radii.
TEST_F(Molecules, AreNoDropsOfALiquid) {
    EXPECT_THAT(wrong("m.xyz", "2\n\ndrop 0 0 0\ndrop 1 0 0\n"),
                testing::HasSubstr("unknown name 'radius'"));
}

TEST_F(Molecules, MoveFromFrameToFrameOfOneFile) {
    const std::string text = "2\nfirst\nC 0 0 0\nO 1 0 0\n"
                             "3\nsecond\nC 0 1 0\nO 1 1 0\nN 5 5 5\n"
                             "0\nnothing\n"
                             "1\nlast\nH 7 7 7\n\n";
    const Scene scene = read("m.xyz", text, 4);
    EXPECT_THAT(field(scene, "cy", 1), ElementsAre(0, 0));
    EXPECT_THAT(field(scene, "cy", 2), ElementsAre(1, 1, 5));
    EXPECT_THAT(field(scene, "radius", 2), ElementsAre(1.7, 1.52, 1.55));
    EXPECT_THAT(field(scene, "cy", 3), ElementsAre());
    EXPECT_THAT(field(scene, "radius", 4), ElementsAre(1.1));
    // Between two times an atom is on its way.
    EXPECT_THAT(scene.surfaces[0].animation.at(0.5).arrays[0].fields[1],
                testing::Contains(DoubleNear(0.5, 1e-12)));
}

TEST_F(Molecules, HaveTheColumnsThatAnExtendedFileStates) {
    const Scene scene =
        read("m.xyz",
             "2\nLattice=\"5 0 0 0 5 0 0 0 5\" "
             "Properties=tag:S:1:species:S:1:pos:R:3:velo:R:3:charge:R:1 pbc=\"T\"\n"
             "a Fe 1 2 3 0 0 0 2\nb Cl 4 5 6 0 0 0 -1\n",
             1, " + charge");
    EXPECT_THAT(field(scene, "cx"), ElementsAre(1, 4));
    EXPECT_THAT(field(scene, "cz"), ElementsAre(3, 6));
    EXPECT_THAT(field(scene, "charge"), ElementsAre(2, -1));
    EXPECT_THAT(field(scene, "atomic_number"), ElementsAre(26, 17));
}

TEST_F(Molecules, ThatAreCutOffAreMistakes) {
    EXPECT_EQ(wrong("m.xyz", "1\n\nC 0 0 0\n2\n\nC 0 0 0\n", 2),
              "m.xyz:7: the count in line 4 says that there are 2 particles; 1 are here");
    EXPECT_EQ(wrong("m.xyz", "0\n\n1\n\nC 0 0 0\n", 2),
              "m.xyz:2: the first frame has no particle; it must tell what columns there are");
    EXPECT_EQ(wrong("m.xyz", "1\n\nC 0 0 0\n1\n\nC 0 0\n", 2),
              "m.xyz:6: has 3 words; the rows before have 4");
    EXPECT_EQ(wrong("m.xyz", "1\n\nC 0 0 0\n99999999999999999999\n\nC 0 0 0\n"),
              "m.xyz:4: follows the 1 particles that the file has so far; those of another time "
              "begin with their count");
}

// A file for each frame that holds several times itself.
TEST_F(Molecules, AreOfOneTimeWhereEachFrameHasAFile) {
    for (const char* file : {"m.1.xyz", "m.2.xyz"}) write(file, "1\n\nC 0 0 0\n1\n\nC 0 1 0\n");
    EXPECT_THAT(mistake(atoms_of("m.#.xyz", 2)),
                testing::HasSubstr("frame: the file holds several times"));
}

std::string pdb_atom(const char* name, double x, double y, const char* element,
                     char alternative = ' ', const char* record = "ATOM  ") {
    return fmt::format("{}{:5} {:<4}{}ALA A   1    {:8.3f}{:8.3f}{:8.3f}{:6.2f}{:6.2f}          "
                       "{:>2}\n",
                       record, 1, name, alternative, x, y, 0.25, 1.0, 20.5, element);
}

TEST_F(Molecules, OfPdbAreReadByTheirColumns) {
    const std::string text =
        "HEADER    PEPTIDE\nREMARK  by hand\n" + pdb_atom(" N  ", -1, 0, "N") +
        pdb_atom(" CA ", 0, 1, "C") + pdb_atom("CA  ", 1, 2, "", ' ', "HETATM") +
        pdb_atom(" CA ", 2, 3, "") + pdb_atom("HG11", 3, 4, "") + pdb_atom("1HB ", 4, 5, "") +
        pdb_atom(" OXT", 5, 6, "O1") + "TER\nEND\n";
    const Scene scene = read("m.pdb", text, 1, " + b_factor + occupancy");
    EXPECT_THAT(field(scene, "atomic_number"), ElementsAre(7, 6, 20, 6, 1, 1, 8));
    EXPECT_THAT(field(scene, "cx"), ElementsAre(-1, 0, 1, 2, 3, 4, 5));
    EXPECT_THAT(field(scene, "cz"), Each(0.25));
    EXPECT_THAT(field(scene, "b_factor"), Each(20.5));
    EXPECT_THAT(field(scene, "occupancy"), Each(1));
    // It is known by its first record, whatever its name.
    EXPECT_THAT(field(read("m.dat", text), "atomic_number"), ElementsAre(7, 6, 20, 6, 1, 1, 8));
}

TEST_F(Molecules, OfPdbAreAtOnePlaceEachAndMoveWithItsModels) {
    std::string text;
    for (const int model : {1, 2, 3}) {
        text += fmt::format("MODEL     {:4}\n", model) + pdb_atom(" N  ", model, 0, "N") +
                pdb_atom(" CA ", model, 1, "C", 'A') + pdb_atom(" CA ", model, 9, "C", 'B') +
                "ENDMDL\n";
    }
    const Scene scene = read("m.pdb", text, 3);
    for (const int model : {1, 2, 3}) {
        EXPECT_THAT(field(scene, "cx", model), ElementsAre(model, model));
        EXPECT_THAT(field(scene, "cy", model), ElementsAre(0, 1));
    }
}

// Residues have alternatives of their own letters. What lines' numbers of old files say is no
// element.
TEST_F(Molecules, OfPdbAreThereOncePerResidue) {
    auto in_residue = [](std::string atom, int residue) {
        return atom.replace(22, 4, fmt::format("{:4}", residue));
    };
    const std::string text = in_residue(pdb_atom(" CA ", 1, 0, "C", 'A'), 1) +
                             in_residue(pdb_atom(" CA ", 2, 0, "C", 'B'), 1) +
                             in_residue(pdb_atom(" O  ", 3, 0, "O", 'B'), 2) +
                             in_residue(pdb_atom(" CA ", 4, 0, " 6", 'C'), 3) +
                             in_residue(pdb_atom(" N  ", 5, 0, "1", 'D'), 3) +
                             in_residue(pdb_atom(" N  ", 6, 0, " 1"), 4);
    const Scene scene = read("m.pdb", text);
    EXPECT_THAT(field(scene, "cx"), ElementsAre(1, 3, 4, 6));
    EXPECT_THAT(field(scene, "atomic_number"), ElementsAre(6, 8, 6, 7));
}

TEST_F(Molecules, OfPdbMayBeMissingFromAModel) {
    const std::string atom = pdb_atom(" N  ", 1, 0, "N");
    const Scene scene = read("m.pdb",
                             "MODEL        1\n" + atom + "ENDMDL\nMODEL        2\nENDMDL\n" +
                                 "MODEL        3\n" + atom + "ENDMDL\nMODEL        4\nENDMDL\n",
                             4);
    for (const int frame : {1, 2, 3, 4})
        EXPECT_EQ(field(scene, "cx", frame).size(), frame % 2) << frame;
}

TEST_F(Molecules, OfPdbThatAreNoneAreMistakes) {
    EXPECT_EQ(wrong("m.pdb", "HEADER    PEPTIDE\nEND\n"), "m.pdb: has no record ATOM or HETATM");
    EXPECT_EQ(wrong("m.pdb", "ATOM      1  N   ALA A   1      1.0\n"),
              "m.pdb:1: y: '' is not a number");
    EXPECT_THAT(wrong("m.cif", "data_1abc\n_cell.length_a 5\n"),
                testing::HasSubstr("m.cif: is CIF; write it as PDB or XYZ"));
    EXPECT_THAT(wrong("m.txt", "ITEM: TIMESTEP\n0\n"), testing::HasSubstr("is a dump of LAMMPS"));
}

} // namespace
} // namespace isomotion::scene
