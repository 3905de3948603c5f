// The chemical elements: what files of molecules leave for their readers to know.
//
// Radii are van der Waals', in ångströms: Mantina et al., Consistent van der Waals Radii for the
// Whole Main Group, J. Phys. Chem. A 113, 2009; for others as the CRC Handbook has them, and 2
// where none is known. Colours are those that Jmol gave to many programs.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace isomotion::scene {

struct ChemicalElement {
    std::string_view symbol;
    double radius;
    std::uint32_t color; // 0xrrggbb, sRGB
};

inline constexpr int chemical_elements = 118;

// Atomic numbers begin at 1; 0 stands for atoms of no known element, which are drawn, too.
const ChemicalElement& chemical_element(int atomic_number);

// The atomic number that a symbol states in small or capital letters, or with a label ("C12",
// "Na+"), or as a number; 0 if it is none. D and T are hydrogen.
int atomic_number(std::string_view symbol);

// The columns that an element gives an atom, and their numbers. Colours are linear, as fields of
// arrays are.
inline constexpr std::array<const char*, 5> element_columns{"atomic_number", "radius", "r", "g",
                                                            "b"};
std::array<double, element_columns.size()> element_numbers(int atomic_number);

} // namespace isomotion::scene
