#include "scene/particles/chemical_elements.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "scene/srgb.h"

namespace isomotion::scene {
namespace {

// clang-format off
constexpr ChemicalElement elements[chemical_elements + 1] = {
    {"", 1.5, 0xff1493},
    {"H", 1.1, 0xffffff},
    {"He", 1.4, 0xd9ffff},
    {"Li", 1.81, 0xcc80ff},
    {"Be", 1.53, 0xc2ff00},
    {"B", 1.92, 0xffb5b5},
    {"C", 1.7, 0x909090},
    {"N", 1.55, 0x3050f8},
    {"O", 1.52, 0xff0d0d},
    {"F", 1.47, 0x90e050},
    {"Ne", 1.54, 0xb3e3f5},
    {"Na", 2.27, 0xab5cf2},
    {"Mg", 1.73, 0x8aff00},
    {"Al", 1.84, 0xbfa6a6},
    {"Si", 2.1, 0xf0c8a0},
    {"P", 1.8, 0xff8000},
    {"S", 1.8, 0xffff30},
    {"Cl", 1.75, 0x1ff01f},
    {"Ar", 1.88, 0x80d1e3},
    {"K", 2.75, 0x8f40d4},
    {"Ca", 2.31, 0x3dff00},
    {"Sc", 2.3, 0xe6e6e6},
    {"Ti", 2.15, 0xbfc2c7},
    {"V", 2.05, 0xa6a6ab},
    {"Cr", 2.05, 0x8a99c7},
    {"Mn", 2.05, 0x9c7ac7},
    {"Fe", 2.05, 0xe06633},
    {"Co", 2.0, 0xf090a0},
    {"Ni", 2.0, 0x50d050},
    {"Cu", 2.0, 0xc88033},
    {"Zn", 2.1, 0x7d80b0},
    {"Ga", 1.87, 0xc28f8f},
    {"Ge", 2.11, 0x668f8f},
    {"As", 1.85, 0xbd80e3},
    {"Se", 1.9, 0xffa100},
    {"Br", 1.83, 0xa62929},
    {"Kr", 2.02, 0x5cb8d1},
    {"Rb", 3.03, 0x702eb0},
    {"Sr", 2.49, 0x00ff00},
    {"Y", 2.4, 0x94ffff},
    {"Zr", 2.3, 0x94e0e0},
    {"Nb", 2.15, 0x73c2c9},
    {"Mo", 2.1, 0x54b5b5},
    {"Tc", 2.05, 0x3b9e9e},
    {"Ru", 2.05, 0x248f8f},
    {"Rh", 2.0, 0x0a7d8c},
    {"Pd", 2.05, 0x006985},
    {"Ag", 2.1, 0xc0c0c0},
    {"Cd", 2.2, 0xffd98f},
    {"In", 2.2, 0xa67573},
    {"Sn", 1.93, 0x668080},
    {"Sb", 2.17, 0x9e63b5},
    {"Te", 2.06, 0xd47a00},
    {"I", 1.98, 0x940094},
    {"Xe", 2.16, 0x429eb0},
    {"Cs", 3.43, 0x57178f},
    {"Ba", 2.68, 0x00c900},
    {"La", 2.5, 0x70d4ff},
    {"Ce", 2.48, 0xffffc7},
    {"Pr", 2.47, 0xd9ffc7},
    {"Nd", 2.45, 0xc7ffc7},
    {"Pm", 2.43, 0xa3ffc7},
    {"Sm", 2.42, 0x8fffc7},
    {"Eu", 2.4, 0x61ffc7},
    {"Gd", 2.38, 0x45ffc7},
    {"Tb", 2.37, 0x30ffc7},
    {"Dy", 2.35, 0x1fffc7},
    {"Ho", 2.33, 0x00ff9c},
    {"Er", 2.32, 0x00e675},
    {"Tm", 2.3, 0x00d452},
    {"Yb", 2.28, 0x00bf38},
    {"Lu", 2.27, 0x00ab24},
    {"Hf", 2.25, 0x4dc2ff},
    {"Ta", 2.2, 0x4da6ff},
    {"W", 2.1, 0x2194d6},
    {"Re", 2.05, 0x267dab},
    {"Os", 2.0, 0x266696},
    {"Ir", 2.0, 0x175487},
    {"Pt", 2.05, 0xd0d0e0},
    {"Au", 2.1, 0xffd123},
    {"Hg", 2.05, 0xb8b8d0},
    {"Tl", 1.96, 0xa6544d},
    {"Pb", 2.02, 0x575961},
    {"Bi", 2.07, 0x9e4fb5},
    {"Po", 1.97, 0xab5c00},
    {"At", 2.02, 0x754f45},
    {"Rn", 2.2, 0x428296},
    {"Fr", 3.48, 0x420066},
    {"Ra", 2.83, 0x007d00},
    {"Ac", 2.0, 0x70abfa},
    {"Th", 2.4, 0x00baff},
    {"Pa", 2.0, 0x00a1ff},
    {"U", 2.3, 0x008fff},
    {"Np", 2.0, 0x0080ff},
    {"Pu", 2.0, 0x006bff},
    {"Am", 2.0, 0x545cf2},
    {"Cm", 2.0, 0x785ce3},
    {"Bk", 2.0, 0x8a4fe3},
    {"Cf", 2.0, 0xa136d4},
    {"Es", 2.0, 0xb31fd4},
    {"Fm", 2.0, 0xb31fba},
    {"Md", 2.0, 0xb30da6},
    {"No", 2.0, 0xbd0d87},
    {"Lr", 2.0, 0xc70066},
    {"Rf", 2.0, 0xcc0059},
    {"Db", 2.0, 0xd1004f},
    {"Sg", 2.0, 0xd90045},
    {"Bh", 2.0, 0xe00038},
    {"Hs", 2.0, 0xe6002e},
    {"Mt", 2.0, 0xeb0026},
    {"Ds", 2.0, 0xeb0026},
    {"Rg", 2.0, 0xeb0026},
    {"Cn", 2.0, 0xeb0026},
    {"Nh", 2.0, 0xeb0026},
    {"Fl", 2.0, 0xeb0026},
    {"Mc", 2.0, 0xeb0026},
    {"Lv", 2.0, 0xeb0026},
    {"Ts", 2.0, 0xeb0026},
    {"Og", 2.0, 0xeb0026},
};
// clang-format on

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

char capital(char c) { return 'a' <= c && c <= 'z' ? char(c - 'a' + 'A') : c; }

bool are_same(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, capital, capital);
}

} // namespace

const ChemicalElement& chemical_element(int atomic_number) { return elements[atomic_number]; }

int atomic_number(std::string_view symbol) {
    int number = 0;
    const char* end = symbol.data() + symbol.size();
    if (const auto [at, error] = std::from_chars(symbol.data(), end, number); at == end)
        return error == std::errc() && 0 < number && number <= chemical_elements ? number : 0;
    const auto letters = std::size_t(std::ranges::find_if_not(symbol, is_letter) - symbol.begin());
    const std::string_view word = symbol.substr(0, letters);
    // What follows is a label or a charge.
    const bool is_label = symbol.find_first_not_of("0123456789+-_*'", letters) == symbol.npos;
    if (word.empty() || !is_label) return 0;
    if (are_same(word, "D") || are_same(word, "T")) return 1;
    const auto* const found = std::ranges::find_if(
        elements, [&](const ChemicalElement& one) { return are_same(one.symbol, word); });
    return found == std::end(elements) ? 0 : int(found - std::begin(elements));
}

std::array<double, element_columns.size()> element_numbers(int atomic_number) {
    const ChemicalElement& element = chemical_element(atomic_number);
    const auto part = [&](int shift) {
        return to_linear(double(element.color >> shift & 0xffu) / 255);
    };
    return {double(atomic_number), element.radius, part(16), part(8), part(0)};
}

} // namespace isomotion::scene
