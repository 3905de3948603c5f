// Writes the JSON schema of scene files and the table of keys in docs/scene-file.md anew, after a
// row of src/scene/key_tables.h has changed: key_documents FOLDER_OF_THE_SOURCES
#include <cstdio>
#include <exception>
#include <filesystem>
#include <span>
#include <string>

#include "base/file.h"
#include "base/file_text.h"
#include "scene/key_documents.h"

namespace {

using namespace isomotion;

void write(const std::filesystem::path& file, const std::string& text) {
    base::write_whole(file, std::as_bytes(std::span(text)));
}

void write_all(const std::filesystem::path& sources) {
    const auto sections = scene::key_sections();
    write(sources / "animations" / "scene.schema.json", scene::schema_text(sections));
    const std::filesystem::path page = sources / "docs" / "scene-file.md";
    write(page, scene::with_key_table(base::file_text(page, 1 << 20), sections));
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "key_documents FOLDER_OF_THE_SOURCES\n");
        return 2;
    }
    try {
        write_all(arguments[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
