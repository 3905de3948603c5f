#include "scene/reading/pov_includes.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "base/file_text.h"
#include "base/printable.h"
#include "scene/error.h"
#include "scene/limits.h"
#include "scene/reading/named_file.h"
#include "scene/reading/reach.h"

namespace isomotion::scene {
namespace {

namespace fs = std::filesystem;

constexpr int deepest_include = 8; // files that include one another
constexpr int most_includes = 100;

class Includer {
public:
    explicit Includer(const fs::path& file)
        : file_(file)
        , within_(confines(base::open_folder(file.parent_path()), Reach::own_folder)) {}

    void add(const std::vector<PovWord>& words, std::optional<std::size_t> line, int depth) {
        for (std::size_t k = 0; k < words.size(); ++k) {
            PovWord word = words[k];
            if (line) word.line = *line;
            const bool is_end = word.kind == PovWord::Kind::end;
            if (is_end && depth > 0) return;
            const bool is_include = word.is("#include") && words[k + 1].kind == PovWord::Kind::text;
            if (!is_include || !include(words[k + 1].text, word.line, depth)) {
                all.push_back(word);
                continue;
            }
            ++k;
        }
    }

    std::vector<PovWord> all;

private:
    [[noreturn]] void fail(std::size_t line, const std::string& message) const {
        throw SceneError(fmt::format("{}:{}: #include: {}", file_.string(), line + 1,
                                     base::printable_line(message)));
    }

    // A name alone: its file can only lie in the scene's folder.
    bool include(const std::string& name, std::size_t line, int depth) {
        if (is_povs_own_file(name) || name.empty() || fs::path(name).filename() != name ||
            name == "." || name == "..")
            return false;
        const fs::path path = file_.parent_path() / name;
        std::error_code error;
        if (!fs::exists(path, error)) return false;
        if (depth >= deepest_include)
            fail(line, fmt::format("more than {} files include one another", deepest_include));
        if (++count_ > most_includes)
            fail(line, fmt::format("more than {} files are included", most_includes));
        std::string text;
        try {
            text = base::file_text(path, limits::scene_bytes - bytes_, within_);
        } catch (const std::runtime_error& error) {
            fail(line, error.what());
        }
        bytes_ += text.size();
        add(pov_words(text, path), line, depth + 1);
        return true;
    }

    const fs::path& file_;
    base::Confines within_;
    std::size_t bytes_ = 0; // of all included files
    int count_ = 0;
};

} // namespace

bool is_povs_own_file(std::string_view name) {
    static constexpr std::string_view known[] = {
        "colors.inc",     "functions.inc", "textures.inc", "shapes.inc", "shapes_old.inc",
        "shapesq.inc",    "metals.inc",    "math.inc",     "finish.inc", "consts.inc",
        "rad_def.inc",    "shapes2.inc",   "glass.inc",    "golds.inc",  "stones.inc",
        "transforms.inc", "woods.inc",     "skies.inc"};
    return std::ranges::count(known, name) > 0;
}

std::vector<PovWord> pov_words_with_includes(std::string_view text, const fs::path& file) {
    Includer includer(file);
    includer.add(pov_words(text, file), std::nullopt, 0);
    return std::move(includer.all);
}

} // namespace isomotion::scene
