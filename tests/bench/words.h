// The words after a bench's name. Only words.cpp knows CLI11, which took each bench four seconds to
// compile.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isomotion::bench {

class Words {
public:
    struct Range {
        int least, most;
    };

    explicit Words(const std::string& about);
    ~Words();

    // Names as "-o,--output". What is not given stays as it is.
    void text(const std::string& names, std::string& to, const std::string& about);
    void one_of(const std::vector<std::string>& values, const std::string& names, std::string& to,
                const std::string& about);
    void texts(const std::string& names, std::vector<std::string>& to,
               const std::string& about); // a,b
    void number(const std::string& names, int& to, const std::string& about);
    void number(const std::string& names, int& to, const std::string& about, const Range& range);
    void number(const std::string& names, double& to, const std::string& about);
    void seed(const std::string& names, std::uint64_t& to, const std::string& about);
    void flag(const std::string& names, bool& to, const std::string& about);
    void folder(const std::string& names, std::filesystem::path& to,
                const std::string& about); // that exists
    void require(const std::string& name);

    // The exit code, where the program ends with it: after help or what is wrong.
    std::optional<int> read(int count, char** words);

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

} // namespace isomotion::bench
