// What the tests of scenes share: a folder of their own with a catalogue in it, and a scene whose
// lines can be exchanged one by one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "scene/reading/load.h"
#include "scene/scene_at.h"

namespace isomotion::scene {

// A ball of radius 1, seen from (4, 0, 0):
//
//    1  title = "A ball"
//    2  [time]
//    3  fps = 30
//    4  frames = 60
//    5  [surface]
//    6  formula = "x^2 + y^2 + z^2 - radius^2"
//    7  bounds = { sphere = 1.5 }
//    8  [parameters]
//    9  radius = 1
//   10  [camera]
//   11  position = [4, 0, 0]
//   12  fov = 40
//   13  [output]
//   14  size = [64, 64]
std::string ball();
// The ball with another text in place of line `number`.
std::string ball_with(int number, const std::string& line);
// The ball with more lines, the first of them line 15.
std::string ball_and(const std::string& lines);

// A sum over blobs; [arrays.blobs] is line 4 and `array`, what is in it, begins with line 5.
std::string blobs(const std::string& array);

class Scenes : public testing::Test {
protected:
    Scenes();
    ~Scenes() override;

    // $ISOMOTION_DATA, empty but for what the test writes.
    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path write(const std::string& name, const std::string& text) const;
    void surface(const std::string& name, const std::string& text) const {
        write("animations/surfaces/" + name + ".toml", text);
    }

    Scene loaded(const std::string& text, const std::vector<Override>& overrides = {}) const;
    SceneAt at_time(const Scene& scene, double time) const { return at(scene, time); }

    // What load says about a scene with a mistake: names of files are relative to the folder.
    std::string mistake(const std::string& text, const std::vector<Override>& overrides = {}) const;
    std::string mistake_of_name(const std::string& name) const;

private:
    template<class Load> std::string caught(Load&& load) const;

    std::filesystem::path folder_;
};

// The message about a scene of another program, whose text is read as that file.
std::string mistake_of_text(const std::string& text, const std::string& file);

// A scene's text and the whole message about it.
struct Mistake {
    std::string text, message;
};

} // namespace isomotion::scene
