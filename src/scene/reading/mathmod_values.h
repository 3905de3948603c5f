// Reads expressions of MathMod's scripts, in the notation of the library fparser, as formulas of
// isomotion.
#pragma once

#include <bitset>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/reading/mathmod_json.h"

namespace isomotion::scene::mathmod {

// An expression as the text of a formula.
struct Part {
    enum class Strength { sum, product, power, atom }; // the weakest operator of the text
    enum Input { x, y, z, u, t };

    std::string text;
    Strength strength = Strength::atom;
    std::optional<double> value; // of a constant
    bool is_condition = false;
    bool is_never_negative = false;
    bool may_jump = false;
    std::bitset<5> inputs;            // that it depends on
    std::set<std::size_t> names;      // definitions that it names
    std::set<std::string> parameters; // beside those of the definitions
    int depth = 0;                    // of parentheses in the text

    // As what `if` chooses by; a number holds if it rounds to another than 0.
    std::string condition() const;
};

Part number_part(double value);
Part input_part(Part::Input input, const std::string& text);

class Values {
public:
    Values();

    // Constants are numbers, computed here from those before them; others call and name what was
    // defined before. `text` is what stands after "=". Names are theirs.
    void add_constant(const std::string& name, std::string_view text, const JsonPlace& at);
    // Comes after the constants, in place of one of its name.
    void add_slider(const std::string& name, double value);
    // Ax is what `text` is with x in place of u, and so for Ay and Az.
    void add_variable(const std::string& name, std::string_view text, const JsonPlace& at);
    // Of x, y, z and t, whatever it names.
    void add_function(const std::string& name, std::string_view text, const JsonPlace& at);

    // Of a place and the time, which is a parameter here.
    Part formula(std::string_view text, const JsonPlace& at) const;
    // Of the time alone, in an expression of the scene, with numbers in place of constants.
    Part limit(std::string_view text, const JsonPlace& at) const;

    // "N = 8; f(x) = N*x; ": what the part names, to stand before it.
    std::string definitions_for(const Part& part) const;
    // All parameters that the part depends on.
    std::set<std::string> parameters_of(const Part& part) const;
    const std::string& time() const { return time_; }
    // The value of a parameter.
    double slider(const std::string& parameter) const { return sliders_.at(parameter); }

    struct Definition {
        std::string name, arguments; // "(x, y)", or nothing
        Part part;
    };
    struct Meaning {
        enum class Kind { part, function } kind = Kind::part;
        Part part;                // what the name stands for
        std::size_t function = 0; // the definition that calls name
    };
    const std::map<std::string, Meaning, std::less<>>& meanings() const { return meanings_; }
    const Definition& definition(std::size_t k) const { return definitions_[k]; }

private:
    std::string free_name(const std::string& name);
    std::vector<bool> needed_for(const Part& part) const; // of the definitions
    std::size_t define(const std::string& name, Part part);

    std::vector<Definition> definitions_; // each names only those before it
    std::map<std::string, Meaning, std::less<>> meanings_;
    std::map<std::string, double> sliders_;
    std::set<std::string> taken_;
    std::string time_ = "time";
};

} // namespace isomotion::scene::mathmod
