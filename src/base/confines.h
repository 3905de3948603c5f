#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/file_descriptor.h"

namespace isomotion::base {

/// Where an open file or folder lies, without links, as the kernel has it. None where that is not
/// to be told: in a system without /proc.
std::optional<std::filesystem::path> place_of(const FileDescriptor& open);

/// An open folder to look names up in, whatever its own name leads to later. Invalid if there is
/// none.
FileDescriptor open_folder(const std::filesystem::path& folder);

/// Where a file may lie that a stranger names. What is asked is the file that is open already and
/// that will be read: a link that is changed after a look at the name leads nowhere.
class Confines {
public:
    Confines() = default; ///< anywhere
    /// In these folders, which are what place_of() says, and in those below them. `refusal` is what
    /// messages say after the name of a file that lies elsewhere.
    Confines(std::vector<std::filesystem::path> folders, std::string refusal)
        : folders_(std::move(folders))
        , refusal_(std::move(refusal)) {}

    bool hold(const FileDescriptor& open) const;
    const std::string& refusal() const { return refusal_; }

    bool operator==(const Confines&) const = default;

private:
    std::optional<std::vector<std::filesystem::path>> folders_;
    std::string refusal_;
};

} // namespace isomotion::base
