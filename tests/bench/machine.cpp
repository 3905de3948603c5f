#include "machine.h"

#include <ctime>
#include <fstream>
#include <thread>

#include <fmt/format.h>

namespace isomotion::bench {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (!line.starts_with("model name")) continue;
        return line.substr(line.find(':') + 2);
    }
    return "unknown processor";
}

} // namespace

std::string machine(const gpu::ContextInfo& info) {
    return fmt::format("{} ({} threads), {} {}", processor(), std::thread::hardware_concurrency(),
                       info.renderer, info.version);
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    return fmt::format("{}-{:02}-{:02}", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday);
}

} // namespace isomotion::bench
