#include "shader/shader_code.h"

#include <algorithm>
#include <cctype>

namespace isomotion::shader {

bool is_of_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string code_of(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    std::string code;
    code.reserve(text.size());
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        line = line.substr(0, line.find("//"));
        const std::size_t first = line.find_first_not_of(blank);
        if (first == std::string_view::npos) continue;
        code += line.substr(first, line.find_last_not_of(blank) + 1 - first);
        code += '\n';
    }
    return code;
}

} // namespace isomotion::shader
