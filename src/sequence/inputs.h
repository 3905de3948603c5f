// Keeps outputs from replacing the files that they are made from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::sequence {

// Files are known by what they are, not by their names: "./a", a link and another name of the same
// file are one.
class Inputs {
public:
    explicit Inputs(const std::vector<std::filesystem::path>& files);
    explicit Inputs(const scene::Scene& scene);

    // Another file that is read; empty: none.
    void add(const std::filesystem::path& file);

    // Each throws an Error (setting), naming the option and the input, if something would be
    // written over an input. Call them before anything is written. An empty name writes nothing.
    void expect_apart(std::string_view option, const std::filesystem::path& output) const;
    // The same for all frames of a name. Looks only at files that are there.
    void expect_apart(std::string_view option, const SequenceName& frames) const;

private:
    using Identity = std::pair<std::uint64_t, std::uint64_t>; // device and inode
    std::map<Identity, std::filesystem::path> files_;
};

} // namespace isomotion::sequence
