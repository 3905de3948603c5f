// Computes a polynomial's Bernstein coefficients from its samples.
#pragma once

#include <string>
#include <vector>

namespace isomotion::synthesis {

// The places in [0, 1] at which a polynomial of `degree` >= 1 is sampled: (1 + g(u)) / 2 for u = -1
// to 1 in equal steps, where g(u) = u (a + b u^2 + c u^4) is sin(pi u / 2) to 2e-4. So these are
// Chebyshev's points with both ends, which successive pieces of a ray share, at the price of five
// products.
std::vector<double> sample_places(int degree);

// Row i holds the samples' weights in coefficient i. Weights are symmetric: weights[d - i][d - k] =
// weights[i][k].
std::vector<std::vector<double>> bernstein_weights(int degree);

// float sample_place(int k); void to_bernstein(float f[DEGREE + 1], out float b[DEGREE + 1]). The
// weights apply to sums and differences of opposite samples, which halves the number of products.
std::string bernstein_text(int degree);

} // namespace isomotion::synthesis
