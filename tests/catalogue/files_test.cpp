// What a file of the catalogue must hold.
#include <gmock/gmock.h>

#include "recorded.h"
#include "scene/data_folder.h"
#include "scene/reading/document.h"
#include "surface_file.h"

namespace isomotion::catalogue {
namespace {

using testing::ElementsAreArray;

toml::table file_of(const std::string& surface) {
    use_source_tree();
    return scene::read_document(scene::data_folder() / "animations/surfaces" / (surface + ".toml"));
}

TEST(CatalogueFiles, AreTheOnesRecorded) {
    use_source_tree();
    std::vector<std::string> names;
    for (const Recorded& surface : recorded()) names.push_back(surface.name);
    EXPECT_THAT(scene::surface_names(), ElementsAreArray(names));
}

TEST(CatalogueFiles, SayWhatTheSurfaceIsAndWhereItComesFrom) {
    for (const Recorded& surface : recorded()) {
        const toml::table file = file_of(surface.name);
        for (const char* key : {"title", "source"}) {
            EXPECT_NE(file[key].value_or(std::string()), "") << surface.name << ": " << key;
        }
    }
}

TEST(CatalogueFiles, HaveParametersWithARangeToMoveIn) {
    for (const Recorded& surface : recorded()) {
        const auto parameters = parameters_of(surface.name);
        EXPECT_FALSE(parameters.empty()) << surface.name;
        for (const Parameter& parameter : parameters) {
            SCOPED_TRACE(surface.name + ": " + parameter.name);
            EXPECT_LT(parameter.min, parameter.max);
            EXPECT_LE(parameter.min, parameter.preset);
            EXPECT_LE(parameter.preset, parameter.max);
        }
    }
}

TEST(CatalogueFiles, GiveStepAndThresholds) {
    for (const Recorded& surface : recorded()) {
        SCOPED_TRACE(surface.name);
        const toml::table file = file_of(surface.name);
        const auto number = [&](const char* key) { return file["isolation"][key].value_or(0.0); };
        EXPECT_GT(number("step"), 0);
        EXPECT_LT(number("step"), used(surface.name).at.surfaces[0].bounds.radius / 10);
        EXPECT_GT(number("near"), 0);
        EXPECT_GT(number("far"), number("near"));
        EXPECT_GT(number("horizon"), 0);
    }
}

TEST(CatalogueFiles, LoadWithEachParameterAtEachEnd) {
    for (const Recorded& surface : recorded()) {
        for (const auto& settings : ends_of_parameters(surface.name)) {
            SCOPED_TRACE(surface.name + ": " + describe(settings));
            EXPECT_NO_THROW(
                EXPECT_EQ(used(surface.name, settings).scene.surfaces[0].name, surface.name));
        }
    }
}

TEST(CatalogueFiles, HaveTheRecordedBoundsByDefault) {
    for (const Recorded& surface : recorded()) {
        SCOPED_TRACE(surface.name);
        const scene::BoundsAt bounds = used(surface.name).at.surfaces[0].bounds;
        if (surface.radius > 0) {
            EXPECT_EQ(bounds.shape, scene::Bounds::Shape::sphere);
            EXPECT_EQ(bounds.radius, surface.radius);
            EXPECT_EQ(bounds.centre, glm::dvec3(0));
        } else {
            EXPECT_EQ(bounds.shape, scene::Bounds::Shape::box);
            EXPECT_EQ(bounds.min, surface.min);
            EXPECT_EQ(bounds.max, surface.max);
        }
    }
}

} // namespace
} // namespace isomotion::catalogue
