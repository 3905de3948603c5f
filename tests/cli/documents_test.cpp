// README and docs: commands in blocks marked `sh run` are run, files in blocks marked `toml
// file=...` are written first, and what links point to is there.
#include "cli.h"

#include <fstream>
#include <regex>
#include <sstream>

namespace isomotion::cli {
namespace {

namespace fs = std::filesystem;

const fs::path root = ISOMOTION_SOURCE_DIR;

std::vector<fs::path> documents() {
    std::vector<fs::path> all{root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md"};
    for (const auto& entry : fs::directory_iterator(root / "docs")) {
        if (entry.path().extension() == ".md") all.push_back(entry.path());
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<std::string> lines_of(const fs::path& file) {
    std::ifstream stream(file);
    EXPECT_TRUE(stream) << file;
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// Fenced blocks: what stands behind the fence, and the text.
struct Block {
    std::string mark, text;
    std::size_t line = 0; // of the fence
};

std::vector<Block> blocks_of(const fs::path& file) {
    std::vector<Block> blocks;
    bool is_inside = false;
    const std::vector<std::string> lines = lines_of(file);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (lines[k].starts_with("```")) {
            is_inside = !is_inside;
            if (is_inside) blocks.push_back({lines[k].substr(3), "", k + 1});
        } else if (is_inside) {
            blocks.back().text += lines[k] + "\n";
        }
    }
    EXPECT_FALSE(is_inside) << file << ": a block has no end";
    return blocks;
}

class DocumentCommands : public Cli {};

// Commands run in the order of the document, in a folder for each document.
TEST_F(DocumentCommands, Work) {
    const std::string program = ISOMOTION_PROGRAM;
    int count = 0;
    for (const fs::path& document : documents()) {
        const fs::path place = *this / document.stem().string();
        fs::create_directories(place);
        Circumstances here = circumstances();
        here.folder = place;
        for (const Block& block : blocks_of(document)) {
            constexpr std::string_view file = "toml file=";
            if (block.mark.starts_with(file))
                write((fs::path(document.stem()) / block.mark.substr(file.size())).string(),
                      block.text);
            if (block.mark != "sh run") continue;
            ++count;
            const Ending ending = cli::run(
                {"/bin/sh", "-ec",
                 "PATH=" + program.substr(0, program.rfind('/')) + ":$PATH\n" + block.text},
                here);
            EXPECT_EQ(ending.code, 0) << document << ":" << block.line << "\n"
                                      << block.text << ending;
        }
    }
    EXPECT_GE(count, 6);
}

// The anchor that GitHub makes of a heading.
std::string anchor(const std::string& heading) {
    std::string text;
    for (const char c : heading) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || c == '-' || c == '_' || byte >= 0x80) {
            text += char(byte < 0x80 ? std::tolower(byte) : byte);
        } else if (c == ' ') {
            text += '-';
        }
    }
    return text;
}

std::set<std::string> anchors_of(const fs::path& file) {
    std::set<std::string> anchors;
    for (const std::string& line : lines_of(file)) {
        const std::size_t level = line.find_first_not_of('#');
        if (level != 0 && level != line.npos && line[level] == ' ')
            anchors.insert(anchor(line.substr(level + 1)));
    }
    return anchors;
}

TEST(DocumentLinks, PointToWhatIsThere) {
    const std::regex link(R"(\]\(([^)\s]+)\))");
    int count = 0;
    for (const fs::path& document : documents()) {
        std::string text;
        for (const std::string& line : lines_of(document)) text += line + "\n";
        for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
            const std::string target = (*at)[1];
            if (target.find("://") != target.npos) continue;
            const std::size_t hash = target.find('#');
            const fs::path file =
                hash == 0 ? document : document.parent_path() / target.substr(0, hash);
            ++count;
            ASSERT_TRUE(fs::exists(file)) << document << ": " << target;
            if (hash != target.npos && file.extension() == ".md") {
                EXPECT_TRUE(anchors_of(file).contains(target.substr(hash + 1)))
                    << document << ": " << target;
            }
        }
    }
    EXPECT_GE(count, 40);
}

} // namespace
} // namespace isomotion::cli
