// A field with its first and second derivatives, from the formula's graph, at many points at once.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "formula/field.h"

namespace isomotion {

struct SecondOrder {
    double value = 0;
    glm::dvec3 gradient{0};
    glm::dmat3 hessian{0};
};

class SecondOrderField {
public:
    SecondOrderField(const formula::Field& field, formula::Bindings<double> bindings);
    SecondOrderField(const SecondOrderField&) = delete; // the evaluator refers to the program
    SecondOrderField& operator=(const SecondOrderField&) = delete;

    // Fills `results`, as many as there are points.
    void at(std::span<const glm::dvec3> points, std::span<SecondOrder> results);

private:
    formula::Program program_; // inputs x y z -> F; F_x F_y F_z; F_xx F_yx F_yy F_zx F_zy F_zz
    formula::Evaluator<double> evaluator_;
    formula::Bindings<double> bindings_;
    std::vector<double> columns_; // of the inputs, then of the outputs
};

} // namespace isomotion
