#include "synthesis/bernstein_text.h"

#include <cmath>

#include <fmt/format.h>

namespace isomotion::synthesis {
namespace {

// g(1) = 1: the last sample is at the very end.
constexpr double a = 1.570628, b = -0.643258, c = 1 - a - b;

// The Bernstein polynomial B_i of `degree` at y.
double bernstein(int degree, int i, double y) {
    double binomial = 1;
    for (int k = 0; k < i; ++k) binomial = binomial * (degree - k) / (k + 1);
    return binomial * std::pow(y, i) * std::pow(1 - y, degree - i);
}

std::string literal(double value) {
    const std::string text = fmt::format("{:.9g}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

} // namespace

std::vector<double> sample_places(int degree) {
    std::vector<double> places;
    for (int k = 0; k <= degree; ++k) {
        const double u = 2.0 * k / degree - 1;
        places.push_back(0.5 + 0.5 * u * (a + u * u * (b + u * u * c)));
    }
    return places;
}

// The inverse of the values of the basis at the places, by Gauss and Jordan with pivots: it is as
// well conditioned as the coefficients themselves, some 1e4 for degree 12.
std::vector<std::vector<double>> bernstein_weights(int degree) {
    const auto n = std::size_t(degree + 1);
    const std::vector<double> places = sample_places(degree);
    std::vector<std::vector<double>> rows(n, std::vector<double>(2 * n, 0.0));
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < n; ++i) rows[k][i] = bernstein(degree, int(i), places[k]);
        rows[k][n + k] = 1;
    }
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i; k < n; ++k) {
            if (std::abs(rows[k][i]) > std::abs(rows[pivot][i])) pivot = k;
        }
        std::swap(rows[i], rows[pivot]);
        const double scale = 1 / rows[i][i];
        for (double& value : rows[i]) value *= scale;
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i) continue;
            const double factor = rows[k][i];
            for (std::size_t j = 0; j < 2 * n; ++j) rows[k][j] -= factor * rows[i][j];
        }
    }
    for (auto& row : rows) row.erase(row.begin(), row.begin() + std::ptrdiff_t(n));
    return rows;
}

std::string bernstein_text(int degree) {
    const auto weights = bernstein_weights(degree);
    std::string text =
        fmt::format("float sample_place(int k) {{\n    float u = float(k) * {} - 1.0, v = u * u;\n"
                    "    return 0.5 + u * ({} + v * ({} + v * {}));\n}}\n\n"
                    "void to_bernstein(float f[DEGREE + 1], out float b[DEGREE + 1]) {{\n",
                    literal(2.0 / degree), literal(0.5 * a), literal(0.5 * b), literal(0.5 * c));
    const int opposite = (degree + 1) / 2; // pairs of samples
    for (int k = 1; k < opposite; ++k) {
        text += fmt::format("    float even{0} = f[{0}] + f[{1}], odd{0} = f[{0}] - f[{1}];\n", k,
                            degree - k);
    }
    if (opposite > 0) {
        text += fmt::format("    float even0 = f[0] + f[{0}], odd0 = f[0] - f[{0}], even, odd;\n",
                            degree);
    }
    text += fmt::format("    b[0] = f[0];\n    b[{0}] = f[{0}];\n", degree);
    for (int i = 1; 2 * i <= degree; ++i) {
        const auto& row = weights[std::size_t(i)];
        std::string even, odd;
        for (int k = 0; k < opposite; ++k) {
            const double near = row[std::size_t(k)], far = row[std::size_t(degree - k)];
            even += fmt::format("{}{} * even{}", k ? " + " : "", literal(0.5 * (near + far)), k);
            odd += fmt::format("{}{} * odd{}", k ? " + " : "", literal(0.5 * (near - far)), k);
        }
        if (degree % 2 == 0) {
            const int middle = degree / 2;
            even += fmt::format(" + {} * f[{}]", literal(row[std::size_t(middle)]), middle);
        }
        text += fmt::format("    even = {};\n", even);
        if (2 * i == degree) {
            text += fmt::format("    b[{}] = even;\n", i);
        } else {
            text += fmt::format("    odd = {};\n    b[{}] = even + odd;\n    b[{}] = even - odd;\n",
                                odd, i, degree - i);
        }
    }
    return text + "}\n";
}

} // namespace isomotion::synthesis
