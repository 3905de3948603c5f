// Jets at points, in doubles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/program.h"
#include "topology/field/jet.h"

namespace isomotion::topology {

// Keeps the results of the last evaluation. Use one per thread.
class PointEvaluator {
public:
    // Keeps a reference to the program, which is lowered from jet_at_points() or jet_over_boxes()
    // with so many unknowns and rows.
    PointEvaluator(const formula::Program& program, std::size_t unknowns, std::size_t rows)
        : rows_(rows)
        , evaluator_(program)
        , inputs_(unknowns)
        , outputs_(program.outputs.size()) {}

    template<std::size_t N>
    void evaluate(const formula::Bindings<double>& bindings,
                  std::span<const std::array<double, N>> points) {
        for (std::size_t k = 0; k < inputs_.size(); ++k) {
            inputs_[k].clear();
            for (const auto& point : points) inputs_[k].push_back(point[k]);
        }
        std::vector<std::span<double>> to;
        for (auto& output : outputs_) {
            output.resize(points.size());
            to.emplace_back(output);
        }
        const std::vector<std::span<const double>> from(inputs_.begin(), inputs_.end());
        evaluator_.points(bindings, from, to);
    }
    // The jet at one of those points.
    Jet<double> jet(std::size_t p) const {
        Jet<double> jet;
        unpack(jet, inputs_.size(), rows_, [&](std::size_t k) { return outputs_[k][p]; });
        return jet;
    }

private:
    std::size_t rows_;
    formula::Evaluator<double> evaluator_;
    std::vector<std::vector<double>> inputs_, outputs_;
};

} // namespace isomotion::topology
