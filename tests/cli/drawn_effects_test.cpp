// Scenes with effects drawn at random, at the ends of what numbers can be.
#include <cmath>
#include <cstdlib>
#include <random>

#include "cli.h"

namespace isomotion::cli {
namespace {

using Random = std::mt19937;

template<class T, std::size_t N> const T& any_of(Random& random, const T (&all)[N]) {
    return all[random() % N];
}

std::string number(Random& random) {
    static const char* const usual[] = {"0", "1", "0.5", "0.9999", "2", "1e-3", "'t'"};
    static const char* const extreme[] = {
        "-1",   "1e3",   "1e6",  "-1e6", "1e-30", "1e-38", "1e-45", "1e18",   "1e30",    "-1e30",
        "3e38", "-3e38", "1e39", "-0.0", "1e300", "90",    "180",   "1e-300", "'1e38*t'"};
    return random() % 3 ? any_of(random, usual) : any_of(random, extreme);
}

std::string vector(Random& random) {
    const std::string x = number(random), y = number(random), z = number(random);
    return "[" + x + ", " + y + ", " + z + "]";
}

struct Section {
    const char* name;
    const char* must;                 // lines without which it is no section
    std::vector<const char*> numbers; // keys
    std::vector<const char*> vectors;
};

std::string section(Random& random) {
    static const Section sections[] = {
        {"[[lights]]", "", {"falloff"}, {"position", "color"}},
        {"[[lights]]", "shadow = true\n", {}, {"direction", "color"}},
        {"[fog]", "", {"density", "start"}, {"color"}},
        {"[occlusion]", "", {"radius", "strength"}, {}},
        {"[ground]", "", {"height"}, {"color"}},
        {"[material]", "model = 'ggx'\n", {"roughness", "metallic", "specular"}, {"color"}},
        {"[material]",
         "model = 'blinn-phong'\nreflection = 'self'\n",
         {"shininess"},
         {"back_color"}},
        {"[material]", "transmission = 0.9\n", {"ior"}, {"absorption", "color"}},
        {"[material.colormap]", "value = '1/x'\nrange = [-1, 1e30]\n", {}, {}},
        {"[camera]", "", {"fov", "azimuth", "elevation", "distance", "zoom"}, {"target"}},
        {"[camera]", "projection = 'orthographic'\n", {"height", "zoom"}, {"position", "up"}},
        {"[camera]", "", {"aperture", "focus"}, {"position"}},
    };
    const Section& of = any_of(random, sections);
    std::string text = std::string(of.name) + "\n" + of.must;
    for (const char* key : of.numbers) {
        if (random() % 3) text += std::string(key) + " = " + number(random) + "\n";
    }
    for (const char* key : of.vectors) text += std::string(key) + " = " + vector(random) + "\n";
    return text;
}

class DrawnEffects : public Cli {};

TEST_F(DrawnEffects, AreDrawnInFiniteColoursOrRefused) {
    const char* const given = std::getenv("ISOMOTION_SEED");
    const unsigned seed = given ? unsigned(std::atoi(given)) : 1;
    Random random(seed);
    constexpr int tried = 60;
    int drawn = 0, held = 0;
    for (int k = 0; k < tried; ++k) {
        std::string effects;
        for (auto n = 1 + random() % 2; n > 0; --n) effects += section(random);
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", scene " << k << ":\n" << effects);
        write("drawn.toml", sphere_scene() + effects);
        const Ending ending = run({"render", "drawn.toml", "--frames", "2", "--size", "16x16",
                                   "--set", "output.samples=1", "-o", "a.exr", "--quiet"});
        EXPECT_TRUE(ending.code == 0 || ending.code == 2) << ending;
        if (ending.code == 2) {
            EXPECT_THAT(ending.err, StartsWith("drawn.toml:"));
        } else if (ending.code == 0) {
            ++drawn;
            for (const image::Channel& channel : image::decode(*this / "a.exr").channels) {
                for (const float sample : channel.samples)
                    EXPECT_TRUE(std::isfinite(sample)) << channel.name;
            }
        }
        held += !HasFailure();
    }
    EXPECT_GT(drawn, tried / 6) << "hardly a scene was drawn, seed " << seed;
    RecordProperty("tried", tried);
    RecordProperty("held", held);
}

} // namespace
} // namespace isomotion::cli
