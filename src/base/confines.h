#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/file_descriptor.h"

namespace isomotion::base {

/// The path of an open file or folder, without links, as the kernel knows it. Empty if that is not
/// available: in a system without /proc.
std::optional<std::filesystem::path> place_of(const FileDescriptor& open);

/// Opens a folder to look up names in it, even if its own path leads elsewhere later. Invalid if
/// there is none.
FileDescriptor open_folder(const std::filesystem::path& folder);

/// The places where a file may lie that a stranger names. The check is made on the open file that
/// will be read, so a link changed after the check has no effect.
class Confines {
public:
    Confines() = default; ///< anywhere
    /// Inside these folders, given as place_of() returns them. Messages append `refusal` to the
    /// name of a file that lies elsewhere.
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
