// A sum so long that loops over it near the driver's limit of iterations.
#pragma once

#include <string>

#include <fmt/format.h>

namespace isomotion::render {

// Blobs in three piles; `weight` is an expression of i and n, `more` further sections of the scene.
inline std::string piled_blobs(int count, const std::string& weight, const std::string& more) {
    return fmt::format(R"toml(
[surface]
formula = "sum(blobs, weight*exp(-4*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.5"
bounds = {{ sphere = 2 }}
[arrays.blobs]
count = {}
cx = "0.6*cos(2*pi*i/3)"
cy = "0.6*sin(2*pi*i/3)"
cz = "0*i"
weight = "{}"
[camera]
position = [4, 1, 2]
{})toml",
                       count, weight, more);
}

} // namespace isomotion::render
