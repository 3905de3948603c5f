// Command lines drawn at random, of words that mean something and words that mean harm.
#include <cstdlib>
#include <random>

#include "base/printable.h"
#include "cli.h"
#include "farm/nasty_words.h"

namespace isomotion::cli {
namespace {

using Random = std::mt19937;

const Words& any_of(Random& random, const std::vector<Words>& all) {
    return all[random() % all.size()];
}

// What each command is about, so that many of them get beyond the first mistake.
Words drawn(Random& random) {
    static const std::vector<Words> commands{
        {"render", "sphere.toml", "--frames", "1"},
        {"render", "sphere.toml", "--frames", "2", "-o", "a.####.exr"},
        {"show", "sphere.toml"},
        {"accuracy", "sphere.toml", "--size", "8x8"},
        {"topology", "sphere.toml", "--frames", "1"},
        {"submit", "sphere.toml", "--dry-run", "--engine", "print"},
        {"submit", "sphere.toml", "--dry-run", "--engine", "slurm"},
        {"verify", "out"},
        {"verify", "a.####.exr"},
        {"list"},
        {"describe", "--as", "json"},
        {},
    };
    static const std::vector<Words> options{
        {"--size"},    {"--set"},     {"--set=r=2"},    {"--method"}, {"--step"},
        {"--frames"},  {"-o"},        {"--output"},     {"--bits"},   {"--channels"},
        {"--audit"},   {"--certify"}, {"--max-wrong"},  {"--resume"}, {"--quiet"},
        {"--json"},    {"--pixels"},  {"--chunk"},      {"--tries"},  {"--dt"},
        {"--check"},   {"--engine"},  {"--sbatch"},     {"--help"},   {"--allow-outside"},
        {"--backend"}, {"--stage"},   {"--frames=1-2"}, {"--"},       {"--no-such-option"},
    };
    static const Words values{
        "1",
        "0",
        "-1",
        "1e400",
        "nan",
        "inf",
        "8x8",
        "0x0",
        "1x99999999999",
        "1-",
        "3-1x0",
        "1,1,1",
        "10000000",
        "4294967298",
        "a.####.png",
        "a.%04d.png",
        "a.%099d.png",
        "##.##.exr",
        "a.bmp",
        ".",
        "..",
        "r=2",
        "r=",
        "=",
        "r=1/0",
        "r=nan",
        "r=sin(",
        "camera.fov=0",
        "output.size=[1e9,1]",
        "isolation.step=1e-300",
        "affine",
        "z,n",
        "z,,n",
        "egl",
        "compute",
        "sphere.toml",
        "/dev/null",
        "no/such",
        "",
        "auto",
        "off",
        "surface.formula=x",
    };
    Words words = any_of(random, commands);
    for (auto n = random() % 5; n > 0; --n) {
        Words more = any_of(random, options);
        switch (random() % 4) {
        case 0:
            break;
        case 1:
            more.push_back(farm::nasty_word(random));
            break;
        default:
            more.push_back(values[random() % values.size()]);
        }
        words.insert(words.end(), more.begin(), more.end());
    }
    // Where frames go is a name in the folder, whatever was drawn.
    for (std::string& word : words) {
        for (std::size_t slash = 0; (slash = word.find('/', slash)) != word.npos; ++slash) {
            if (word != "/dev/null" && word != "no/such") word[slash] = '_';
        }
    }
    return words;
}

std::string shown(const Words& words) {
    std::string text;
    for (const std::string& word : words) text += "'" + base::printable_line(word) + "' ";
    return text;
}

class DrawnCommandLines : public Cli {};

TEST_F(DrawnCommandLines, EndWithACodeThatSaysWhy) {
    const char* const given = std::getenv("ISOMOTION_SEED");
    const unsigned seed = given ? unsigned(std::atoi(given)) : 1;
    Random random(seed);
    constexpr int tried = 60;
    int done = 0, held = 0;
    for (int k = 0; k < tried; ++k) {
        const Words words = drawn(random);
        SCOPED_TRACE(testing::Message()
                     << "seed " << seed << ", line " << k << ": " << shown(words));
        const Ending ending = run(words);
        EXPECT_EQ(ending.signal, 0) << ending;
        EXPECT_THAT(ending.code, testing::AllOf(testing::Ge(0), testing::Le(3))) << ending;
        EXPECT_TRUE(ending.code < 2 || !(ending.err + ending.out).empty()) << "says nothing";
        expect_only_whole_files();
        done += ending.code == 0;
        held += !HasFailure();
    }
    EXPECT_GT(done, 0) << "no line was right, seed " << seed;
    RecordProperty("tried", tried);
    RecordProperty("held", held);
}

} // namespace
} // namespace isomotion::cli
