// Truth is certified once, and never taken from a file of another picture or a damaged one.
#include "accuracy/truth_cache.h"

#include <cstring>
#include <fstream>

#include "render/drawing.h"
#include "unit/image/places.h"

namespace isomotion::accuracy {
namespace {

class TruthCache : public testing::Test {
protected:
    // Whether certifying took place.
    bool certifies(const std::vector<scene::Override>& settings = {}, int size = 24) {
        const scene::Scene scene = render::scene_of(render::sphere_scene, settings);
        bool asked = false;
        roots::Certifying how;
        how.progress = [&](double) { asked = true; };
        last_ = remembered_truth(scene, scene::at_frame(scene, 1), size, size, how,
                                 folder_.path() / "truth");
        return asked;
    }
    std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "truth")) {
            found.push_back(entry.path());
        }
        return found;
    }

    image::TemporaryFolder folder_;
    roots::Truth last_;
};

TEST_F(TruthCache, RemembersWhatItCertified) {
    EXPECT_TRUE(certifies());
    const roots::Truth first = last_;
    EXPECT_FALSE(certifies());
    EXPECT_EQ(last_.evaluations, first.evaluations);
    ASSERT_EQ(last_.roots.size(), first.roots.size());
    for (std::size_t k = 0; k < first.roots.size(); ++k) {
        EXPECT_EQ(last_.roots[k].answer, first.roots[k].answer);
        EXPECT_EQ(last_.roots[k].low, first.roots[k].low);
        EXPECT_EQ(last_.roots[k].high, first.roots[k].high);
    }
}

TEST_F(TruthCache, WhatTruthDependsOnMakesAnother) {
    EXPECT_TRUE(certifies());
    for (const char* setting :
         {"surface.formula=\"x^2 + y^2 + z^2 - 1.1\"", "surface.bounds={sphere=1.6}",
          "surface.transform.translate=[0.1,0,0]", "surface.transform.scale=1.1",
          "camera.position=[5,0.1,0]", "camera.fov=41", "camera.zoom=1.1",
          "camera.projection=orthographic"}) {
        EXPECT_TRUE(certifies({setting})) << setting;
    }
    EXPECT_TRUE(certifies({}, 25));
    EXPECT_FALSE(certifies()) << "the first is still there";
}

TEST_F(TruthCache, WhatItDoesNotDependOnIsTheSame) {
    EXPECT_TRUE(certifies());
    for (const char* setting : {"isolation.step=0.5", "isolation.method=marching",
                                "material.color=[1,0,0]", "output.background=[0,0,0]"}) {
        EXPECT_FALSE(certifies({setting})) << setting;
    }
}

TEST_F(TruthCache, DamagedFilesAreCertifiedAnew) {
    EXPECT_TRUE(certifies());
    ASSERT_EQ(files().size(), 1u);
    const auto file = files()[0];
    const auto size = std::filesystem::file_size(file);
    std::filesystem::resize_file(file, size - 1);
    EXPECT_TRUE(certifies());
    EXPECT_FALSE(certifies());
    {
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekp(std::streamoff(size / 2));
        stream.put('x');
        stream.put('y');
    }
    EXPECT_TRUE(certifies());
    std::ofstream(file) << "";
    EXPECT_TRUE(certifies());
}

TEST_F(TruthCache, AFolderThatCannotBeOnlyCostsTime) {
    std::ofstream(folder_ / "truth") << "a file where the folder would be";
    EXPECT_TRUE(certifies());
    EXPECT_TRUE(certifies());
}

} // namespace
} // namespace isomotion::accuracy
