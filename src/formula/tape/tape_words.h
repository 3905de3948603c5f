// Tapes as words for the interpreter in shaders/tape/, and its operations in GLSL.
//
// An instruction is two words of 32 bits. The first holds, from the lowest bit: 7 of the operation,
// one that tells that the second operand is a number and not a register, one that exchanges both
// operands, one that tells that the number is the interval up to the next float, 11 of the register
// that takes the result, 11 of the first operand's. The second word is the second operand's
// register, or the number.
//
// Operations that take a processor as long as dozens of products are calls. Software renderers
// compute every operation for each instruction and keep one result. So calls have a place of their
// own: a tape is a row of groups, each a call, the number of instructions behind it, and these. A
// call's third operand is held by an instruction before it.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "formula/tape/tape.h"

namespace isomotion::formula {

// The interpreter runs so many instructions in one turn of its loop.
inline constexpr int tape_unrolled = 8;
inline constexpr int most_tape_registers = 2048;

// `decorated`: intervals, and whether an operation on the way to them is not smooth over the box.
enum class TapeNumbers { floats, intervals, decorated };

// The operations of one function's tapes, whatever they are specialised to.
class TapeOperations {
public:
    TapeOperations(const Tape& whole, TapeNumbers numbers);

    // NUMBER <prefix>_apply(uint op, NUMBER a, NUMBER b, NUMBER held_a, NUMBER held_b), the same
    // for calls as <prefix>_call if there are any, and what they need. Where numbers are decorated,
    // these set the global tape_is_rough at what graph/roughness.h calls kinks, jumps and poles;
    // powers of kinks count as the kinks.
    std::string glsl(const std::string& prefix) const;
    std::set<std::string> kernels() const;
    bool has_calls() const { return !calls_.empty(); }
    // Whether words have room for their codes.
    bool have_codes() const;

    TapeNumbers numbers() const { return numbers_; }
    int orders_of_noise() const;
    // The number of the operation, which counts calls apart from others.
    std::uint32_t code(const TapeStep& step) const;
    static bool is_call(const TapeStep& step);

    // load: b; hold: a, and keeps both for the selection or the call that follows; join: the hull
    // of both.
    static constexpr std::uint32_t load = 0, hold = 1, join = 2, first_code = 3;

private:
    struct Operation {
        Op op{};
        int index = 0, second = 0;
        bool of_one = false; // the square
        bool is_exact = false;
        auto key() const { return std::tie(op, index, second, of_one, is_exact); }
        friend bool operator<(const Operation& a, const Operation& b) { return a.key() < b.key(); }
        friend bool operator==(const Operation& a, const Operation& b) {
            return a.key() == b.key();
        }
    };
    Operation operation(const TapeStep& step) const;
    std::string functions(const std::string& name, const std::vector<Operation>& of,
                          std::uint32_t first) const;
    Program program(const Operation& of) const;

    TapeNumbers numbers_;
    std::vector<Operation> operations_, calls_;
};

struct TapeWords {
    std::vector<std::uint32_t> words;
    int registers = 0; // that it takes
    int turns = 0;     // of the interpreter's loops
    int noises = 0;    // calls of noise, whose bounds have loops of their own
};

// None if it takes more than `most` registers. The first registers hold the inputs, those behind
// them take the outputs.
std::optional<TapeWords> words_of(const Tape& tape, const TapeOperations& operations, int inputs,
                                  int most = most_tape_registers);

} // namespace isomotion::formula
