// What the tests of the command line share: a folder of their own, in which isomotion runs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/decode.h"
#include "program.h"
#include "unit/image/places.h"

namespace isomotion::cli {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

using Words = std::vector<std::string>;

// A sphere of radius r about the origin, seen from (4, 0, 0). The formula is in line 6.
std::string sphere_scene();
// The same with another formula; its parameter r stays.
std::string formula_scene(const std::string& formula);

class Cli : public testing::Test {
protected:
    Cli() { write("sphere.toml", sphere_scene()); }

    const std::filesystem::path& folder() const { return folder_.path(); }
    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, const std::string& text) const;

    // isomotion with these arguments, in the folder.
    Ending run(const Words& arguments) const { return run(arguments, circumstances()); }
    Ending run(Words arguments, const Circumstances& circumstances) const;

    // The data comes from the source tree, wherever the build is.
    Circumstances circumstances() const;

    // `render`, which is expected to succeed, without a warning or with this one.
    Ending render(Words arguments, const std::string& warning = {}) const;

    std::string bytes(const std::string& name) const;
    // Names of the files in a folder inside the folder, hidden ones too.
    std::set<std::string> names(const std::string& inside = ".") const;

    // No hidden file and none without bytes, and every picture can be decoded.
    void expect_only_whole_files() const;

private:
    image::TemporaryFolder folder_;
};

} // namespace isomotion::cli
