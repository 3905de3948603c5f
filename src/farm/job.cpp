#include "farm/job.h"

#include "farm/shell.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::farm {
namespace {

using Words = std::vector<std::string>;

Words rendering_words(const Job& job, const std::string& frames) {
    Words words;
    if (!job.environment.empty()) {
        words.push_back("/usr/bin/env");
        words.insert(words.end(), job.environment.begin(), job.environment.end());
    }
    words.insert(words.end(), {job.program.string(), "render", job.scene.string(), "--frames",
                               frames, "--resume", "-o", job.output.string()});
    words.insert(words.end(), job.options.begin(), job.options.end());
    return words;
}

} // namespace

Words chunk_words(const Job& job, const std::string& frames) {
    Words words = rendering_words(job, frames);
    words.insert(words.end(), {"--part-of", job.frames});
    return words;
}

Words joining_words(const Job& job, const std::string& frames) {
    Words words = rendering_words(job, frames);
    for (const auto& movie : job.movies) words.insert(words.end(), {"--movie", movie.string()});
    return words;
}

std::string shell_line(const Job& job, const Words& words) {
    Words all{"cd", job.folder.string()};
    const std::size_t here = all.size();
    all.insert(all.end(), words.begin(), words.end());
    std::string line = newline_definition(all);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k == here) line += "&& ";
        line += shell_word(all[k]) + (k + 1 < all.size() ? " " : "");
    }
    return line;
}

std::string stem(const std::filesystem::path& output) {
    std::string name = sequence::SequenceName::parse(output.string()).stem();
    name.resize(name.find_last_not_of("._- ") + 1);
    return name.empty() ? "frames" : name;
}

} // namespace isomotion::farm
