#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>

#include <sys/mount.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace isomotion::base {

/// An empty folder for one test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "isomotion-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("mkdtemp");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    /// The names in the folder, hidden ones too.
    std::set<std::string> names() const {
        std::set<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            found.insert(entry.path().filename().string());
        return found;
    }

private:
    std::filesystem::path path_;
};

/// A small disk of its own over a folder, where the machine allows mounting one.
class Disk {
public:
    Disk(const TemporaryFolder& folder, unsigned long flags, const char* options)
        : path_(folder.path())
        , mounted_(::mount("tmpfs", path_.c_str(), "tmpfs", flags, options) == 0) {}
    ~Disk() {
        if (mounted_) ::umount(path_.c_str());
    }
    Disk(const Disk&) = delete;
    Disk& operator=(const Disk&) = delete;

    explicit operator bool() const { return mounted_; }

private:
    std::filesystem::path path_;
    bool mounted_;
};

/// Gives an environment variable another value for one test.
class Environment {
public:
    Environment(const char* name, const std::string& value)
        : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        ::setenv(name, value.c_str(), 1);
    }
    ~Environment() {
        if (before_) {
            ::setenv(name_, before_->c_str(), 1);
        } else {
            ::unsetenv(name_);
        }
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

    std::string before() const { return before_.value_or(""); }

private:
    const char* name_;
    std::optional<std::string> before_;
};

} // namespace isomotion::base
