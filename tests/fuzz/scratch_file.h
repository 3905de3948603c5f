// A file of this process, gone with it, for targets whose readers take names of files.
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

namespace isomotion::fuzz {

class ScratchFile {
public:
    explicit ScratchFile(std::string_view stem)
        : path_(std::filesystem::temp_directory_path() / fmt::format("{}.{}", stem, ::getpid())) {}
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ~ScratchFile() { std::filesystem::remove(path_); }

    const std::filesystem::path& holding(std::string_view bytes) const {
        std::ofstream(path_, std::ios::binary | std::ios::trunc)
            .write(bytes.data(), std::streamsize(bytes.size()));
        return path_;
    }

private:
    std::filesystem::path path_;
};

} // namespace isomotion::fuzz
