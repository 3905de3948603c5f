// Names that a shell, sbatch or a format would read something into.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace isomotion::farm {

inline const std::vector<std::string> nasty_words = {
    "a b", "'",     "''",   "\"",    "it's", "$HOME",    "$nl",  "${nl}", "`id`", "$(id)", "\\",
    "\\n", "a\\",   "\n",   "a\nb",  "\n\n", "a\n",      "\r\n", "\r",    "\t",   "*",     "?",
    "[a]", "{a,b}", "~",    "~root", "#",    "#a",       "!",    "!!",    "&",    ";",     "|",
    "<",   ">",     "(",    ")",     "%",    "%j",       "%%",   "%A_%a", "-",    "--",    "-n",
    "=",   "a=b",   "\x01", "\x7f",  "\xff", "\xc3\xa4", ";;",   "esac",  "EOF",  " ",     "  a  "};

// A word of up to 12 of them, or of single bytes.
template<class Random> std::string nasty_word(Random& random) {
    std::string word;
    for (auto n = random() % 12; n > 0; --n) {
        if (random() % 2) {
            word += nasty_words[random() % nasty_words.size()];
        } else {
            word += char(1 + random() % 255);
        }
    }
    return word;
}

} // namespace isomotion::farm
