#include "processes.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace isomotion::farm {
namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// The fourth of a line such as "12 (name) S 11 ...", where a name may hold anything.
pid_t parent_in(const std::string& stat) {
    const std::size_t state = stat.rfind(')') + 2;
    return state + 2 < stat.size() ? pid_t(std::atoi(stat.c_str() + state + 2)) : 0;
}

} // namespace

bool Process::has_word(const std::string& word) const {
    return ('\0' + words).find('\0' + word + '\0') != std::string::npos;
}

std::vector<Process> processes(const std::function<bool(const Process&)>& wanted) {
    std::vector<Process> found;
    std::error_code ended;
    for (std::filesystem::directory_iterator entry("/proc", ended), end; entry != end;
         entry.increment(ended)) {
        const std::filesystem::path folder = entry->path();
        const std::string name = folder.filename();
        Process process;
        const auto [last, error] =
            std::from_chars(name.data(), name.data() + name.size(), process.id);
        if (error != std::errc{} || *last != '\0' || process.id == ::getpid()) continue;
        process.parent = parent_in(text_of(folder / "stat"));
        process.words = text_of(folder / "cmdline");
        process.environment = text_of(folder / "environ");
        if (wanted(process)) found.push_back(std::move(process));
    }
    return found;
}

std::vector<Process> renders_into(const std::string& folder) {
    return processes([&](const Process& process) {
        return process.has_word("render") && process.words.find(folder) != std::string::npos;
    });
}

} // namespace isomotion::farm
