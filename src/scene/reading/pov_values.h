// Reads numbers, vectors and functions of POV-Ray's scene files as formulas of isomotion.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "scene/reading/pov_words.h"

namespace isomotion::scene {

// A number as the text of a formula. A constant in the file also has a value.
struct PovNumber {
    enum class Strength { sum, product, power, atom }; // the weakest operator of the text

    std::string text = "0";
    Strength strength = Strength::atom;
    std::optional<double> value = 0.0;

    static PovNumber of(double value);
    // The value, if the text states only that.
    std::optional<double> plain() const;
    bool is_plain() const { return plain().has_value(); }
};

inline constexpr std::size_t longest_pov_text = 500'000; // of a number or a formula

// Plain numbers are computed, others are left to the formula. The sign is one of + - * / ^.
PovNumber joined(const PovNumber& a, char sign, const PovNumber& b);

// One number, or the parts of a vector or a colour.
using PovValue = std::vector<PovNumber>;

// The values of the first three parts, if none moves.
std::optional<glm::dvec3> still_vector(const PovValue& parts);

// Reads expressions. Names must be declared by the file; a declared number becomes a parameter that
// formulas name.
class PovValues {
public:
    // Declares the value after "=". Returns true if it read one, false if there is no value.
    bool declare(const std::string& name, PovCursor& at);

    // `for_what` names the context in messages: "camera".
    PovValue value(PovCursor& at, std::string_view for_what);
    PovNumber number(PovCursor& at, std::string_view for_what);
    // A single number stands for all three components.
    std::vector<PovNumber> vector(PovCursor& at, std::string_view for_what);
    double constant(PovCursor& at, std::string_view for_what);
    // The body of "function { ... }" with its braces, a function of x, y and z.
    PovNumber function(PovCursor& at);

    bool is_color(const PovWord& word) const;
    bool is_declared(const std::string& name) const {
        return values_.contains(name) || parameter_names_.contains(name);
    }
    // The name is declared again, as something that is no value.
    void forget(const std::string& name);

    struct Parameter {
        std::string name, text;
        std::size_t line = 0;
    };
    const std::vector<Parameter>& parameters() const { return parameters_; }

private:
    struct Function {
        std::vector<std::string> arguments;
        std::size_t body = 0;     // the word after its opening brace
        std::size_t declared = 0; // values and functions that were declared before it
    };
    using Arguments = std::map<std::string, PovNumber>;
    struct Declared {
        std::size_t when; // how many values were declared with it
        PovValue value;
    };

    // What names mean: arguments within a function, and of values declared several times the last
    // of the first `declared`.
    struct Names {
        const Arguments* arguments = nullptr;
        std::size_t declared = 0;
    };
    // Gives names another meaning during its lifetime.
    class Meaning {
    public:
        Meaning(PovValues& values, const Names& there)
            : values_(values)
            , before_(std::exchange(values.meaning_, there)) {}
        ~Meaning() { values_.meaning_ = before_; }
        Meaning(const Meaning&) = delete;
        Meaning& operator=(const Meaning&) = delete;

    private:
        PovValues& values_;
        Names before_;
    };

    PovValue sum(PovCursor& at);
    PovValue product(PovCursor& at);
    PovValue signed_value(PovCursor& at);
    PovValue power(PovCursor& at);
    PovValue part(PovCursor& at);
    PovValue named(PovCursor& at);
    PovValue color(PovCursor& at);
    PovValue list(PovCursor& at);
    PovValue call(PovCursor& at, const std::string& name);
    PovNumber call_declared(PovCursor& at, const std::string& name);
    void expect_short(const PovValue& value, const PovCursor& at) const;
    void declare(const std::string& name, PovValue value, const PovCursor& at);
    void declare_function(const std::string& name, PovCursor& at);
    std::string parameter_of(const std::string& name);
    const Function* known_function(const std::string& name) const;
    const PovValue* known(const std::string& name) const;

    static constexpr std::size_t most_declared = 10'000;
    static constexpr int most_calls = 100'000; // of declared functions, in all of the file

    std::map<std::string, std::vector<Declared>> values_;    // in the order of the file
    std::map<std::string, std::vector<Function>> functions_; // in the order of the file
    std::set<std::string> parameter_names_;
    std::vector<Parameter> parameters_;
    Names meaning_;
    std::string for_what_;
    int depth_ = 0, calls_ = 0;
};

} // namespace isomotion::scene
