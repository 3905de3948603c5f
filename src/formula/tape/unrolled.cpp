#include "formula/tape/unrolled.h"

#include <algorithm>
#include <utility>

#include "formula/graph/operations.h"

namespace isomotion::formula {
namespace {

using Kind = Instruction::Kind;

class Unroller {
public:
    Unroller(const Program& program, const ElementParameters& elements, std::size_t longest)
        : program_(program)
        , elements_(elements)
        , longest_(longest)
        , place_(std::size_t(program.registers), -1) {}

    std::optional<Program> run() {
        copy(0, program_.instructions.size());
        if (is_too_long()) return {};
        for (const Register output : program_.outputs) made_.outputs.push_back(at(output));
        return std::move(made_);
    }

private:
    Register at(Register of) const { return place_[std::size_t(of)]; }
    bool is_too_long() const { return made_.instructions.size() > longest_; }

    Register add(Instruction now) {
        now.result = made_.registers++;
        made_.instructions.push_back(now);
        return now.result;
    }
    Register constant(double value) { return add({.value = value}); }
    Register parameter(int index) { return add({.op = Op::parameter, .index = index}); }
    Register operation(Op op, const std::array<Register, 4>& operands, int arity, int index = 0) {
        return add({.op = op, .arity = std::uint8_t(arity), .index = index, .operands = operands});
    }

    std::size_t end_of_loop(std::size_t begin) const {
        std::size_t at = begin;
        for (int depth = 1; depth > 0;) {
            ++at;
            if (program_.instructions[at].kind == Kind::loop_begin) ++depth;
            if (program_.instructions[at].kind == Kind::loop_end) --depth;
        }
        return at;
    }

    void copy(std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last && !is_too_long(); ++k) {
            const Instruction& now = program_.instructions[k];
            switch (now.kind) {
            case Kind::operation:
                place_[std::size_t(now.result)] = copied(now);
                break;
            case Kind::begin:
                place_[std::size_t(now.result)] = constant(of_none(now.op));
                if (keeps_least(now.op))
                    place_[std::size_t(now.operands[2])] = constant(of_none(Op::least));
                break;
            case Kind::loop_begin: {
                const std::size_t end = end_of_loop(k);
                const ElementRange& range = elements_.range(now.index);
                element_.resize(std::max(element_.size(), std::size_t(now.index) + 1));
                for (int e = 0; e < range.most && !is_too_long(); ++e) {
                    element_[std::size_t(now.index)] = e;
                    copy(k + 1, end);
                }
                k = end;
                break;
            }
            case Kind::accumulate:
                accumulate(now);
                break;
            case Kind::loop_end:
                break;
            }
        }
    }

    Register copied(Instruction now) {
        if (now.op == Op::element)
            return parameter(
                elements_.field(now.index, now.second, element_[std::size_t(now.index)]));
        for (std::size_t k = 0; k < now.arity; ++k) now.operands[k] = at(now.operands[k]);
        return add(now);
    }

    // What a sum, or a least element, is without elements.
    static double of_none(Op op) {
        return op == Op::least ? double(Operations<float>::least_of_none()) : 0;
    }

    // An element that an array has not at all times counts for nothing there.
    Register where_it_is(const Instruction& now, Register value) {
        const int element = element_[std::size_t(now.index)];
        if (element < elements_.range(now.index).least) return value;
        const Register number = constant(element), count = parameter(elements_.count(now.index)),
                       none = constant(of_none(now.op == Op::sum ? Op::sum : Op::least));
        return operation(Op::select, {number, count, value, none}, 4);
    }

    void accumulate(const Instruction& now) {
        const Register key = where_it_is(now, at(now.operands[0]));
        Register& result = place_[std::size_t(now.result)];
        if (now.op == Op::sum) {
            result = operation(Op::add, {result, key}, 2);
        } else if (now.op == Op::least) {
            result = operation(Op::min, {key, result}, 2);
        } else {
            Register& least = place_[std::size_t(now.operands[2])];
            const Register value = now.op == Op::pick
                                       ? at(now.operands[1])
                                       : constant(element_[std::size_t(now.index)] + 1);
            // Tapes may decide it where they decide the least key.
            result = operation(Op::select, {key, least, value, result}, 4, int(Op::min));
            least = operation(Op::min, {key, least}, 2);
        }
    }

    const Program& program_;
    const ElementParameters& elements_;
    std::size_t longest_;
    std::vector<Register> place_; // of the program's registers among those made
    std::vector<int> element_;    // of each array, in the loops around an instruction
    Program made_;
};

} // namespace

ElementParameters::ElementParameters(int parameters, ArrayPacking packing,
                                     std::vector<ElementRange> ranges)
    : parameters_(parameters)
    , packing_(std::move(packing))
    , ranges_(std::move(ranges)) {
    int next = parameters_;
    for (std::size_t a = 0; a < packing_.size(); ++a) {
        first_.push_back(next);
        next += 1 + int(packing_[a].size()) * ranges_[a].most;
    }
}

int ElementParameters::field(int array, int field, int element) const {
    const std::vector<int>& fields = packing_[std::size_t(array)];
    const auto column = int(std::ranges::find(fields, field) - fields.begin());
    return count(array) + 1 + column * range(array).most + element;
}

std::vector<float> ElementParameters::values(const Bindings<float>& bindings) const {
    std::vector<float> all = bindings.parameters;
    all.resize(std::size_t(parameters_));
    for (std::size_t a = 0; a < packing_.size(); ++a) {
        const ArrayColumns<float>& array = bindings.arrays[a];
        all.push_back(float(array.count));
        for (const int field : packing_[a]) {
            const std::vector<float>& column = array.fields[std::size_t(field)];
            all.insert(all.end(), column.begin(), column.begin() + array.count);
            all.resize(all.size() + std::size_t(ranges_[a].most - array.count));
        }
    }
    return all;
}

std::optional<Program> unrolled(const Program& program, const ElementParameters& elements,
                                std::size_t longest) {
    const auto is_loop = [](const Instruction& now) { return now.kind == Kind::loop_begin; };
    if (std::ranges::none_of(program.instructions, is_loop)) return program;
    return Unroller(program, elements, longest).run();
}

} // namespace isomotion::formula
