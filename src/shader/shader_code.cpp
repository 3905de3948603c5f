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

std::string replaced(const std::string& text, const std::map<std::string, std::string>& words) {
    if (words.empty()) return text;
    std::string made;
    for (auto at = text.begin(); at != text.end();) {
        const auto end = std::find_if_not(at, text.end(), is_of_a_word);
        if (end == at) {
            made += *at++;
            continue;
        }
        const std::string word(at, end);
        const auto found = words.find(word);
        made += found == words.end() ? word : found->second;
        at = end;
    }
    return made;
}

} // namespace isomotion::shader
