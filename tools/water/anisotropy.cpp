#include "anisotropy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "grid.h"
#include "parallel.h"

namespace water {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

struct Axes {
    std::array<double, 3> length; // eigenvalues
    Matrix columns;               // unit eigenvectors
};

// Jacobi's rotations of a symmetric matrix: slower than a closed form, and right for every matrix.
Axes axes_of(Matrix a) {
    Matrix v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr int sweeps = 8; // it converges quadratically: 5 are enough for 1e-15
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            if (a[p][q] == 0) continue;
            const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
            const double t =
                (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
            const double c = 1 / std::sqrt(t * t + 1), s = t * c;
            for (std::size_t k = 0; k < 3; ++k) {
                const double kp = a[k][p], kq = a[k][q];
                a[k][p] = c * kp - s * kq;
                a[k][q] = s * kp + c * kq;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double pk = a[p][k], qk = a[q][k];
                a[p][k] = c * pk - s * qk;
                a[q][k] = s * pk + c * qk;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double kp = v[k][p], kq = v[k][q];
                v[k][p] = c * kp - s * kq;
                v[k][q] = s * kp + c * kq;
            }
        }
    }
    return {{a[0][0], a[1][1], a[2][2]}, v};
}

// The neighbourhood of a particle, weighted by Eq. 11.
struct Neighbourhood {
    int count = 0; // without the particle and without mirror images
    Vec3 mean, velocity;
    Matrix covariance{}; // Eq. 9, of a full neighbourhood the unit matrix
};

class Gatherer {
public:
    Gatherer(const Fluid& fluid, float reach)
        : reach_(reach)
        , grid_(fluid.tank().inside, reach / 2)
        , tank_(fluid.tank()) {
        const std::vector<std::uint32_t> order = grid_.sort(fluid.positions());
        for (const std::uint32_t i : order) {
            position_.push_back(fluid.positions()[i]);
            velocity_.push_back(fluid.velocities()[i]);
            id_.push_back(fluid.ids()[i]);
        }
    }

    std::size_t count() const { return position_.size(); }
    Vec3 position(std::size_t i) const { return position_[i]; }
    Vec3 velocity(std::size_t i) const { return velocity_[i]; }
    int id(std::size_t i) const { return id_[i]; }

    Neighbourhood gather(std::size_t i) const {
        const Vec3 p = position_[i];
        Neighbourhood found;
        float weights = 0;
        Vec3 sum, velocities;
        std::array<float, 6> products{}; // of differences from p: xx xy xz yy yz zz
        const auto add = [&](Vec3 d, Vec3 v) {
            const float square = dot(d, d);
            if (square >= reach_ * reach_) return false;
            const float q = std::sqrt(square) / reach_, w = 1 - q * q * q;
            weights += w;
            sum += w * d;
            velocities += w * v;
            products[0] += w * d.x * d.x;
            products[1] += w * d.x * d.y;
            products[2] += w * d.x * d.z;
            products[3] += w * d.y * d.y;
            products[4] += w * d.y * d.z;
            products[5] += w * d.z * d.z;
            return true;
        };
        // Walls mirror the water, which so is as thick at a wall as elsewhere and flat against it.
        const std::vector<Wall> walls = tank_.walls_near(p, reach_ / 2);
        grid_.visit_near(p, reach_, [&](std::size_t from, std::size_t to) {
            for (std::size_t j = from; j < to; ++j) {
                const Vec3 other = position_[j];
                if (!add(other - p, velocity_[j])) continue;
                found.count += j != i;
                for (std::size_t images = 1; images < std::size_t(1) << walls.size(); ++images) {
                    Vec3 image = other, v = velocity_[j];
                    for (std::size_t k = 0; k < walls.size(); ++k) {
                        if (!(images >> k & 1)) continue;
                        image = walls[k].mirrored(image);
                        v -= 2 * dot(v, walls[k].normal) * walls[k].normal;
                    }
                    add(image - p, v);
                }
            }
        });
        const Vec3 shift = (1 / weights) * sum; // Eq. 10
        found.mean = p + shift;
        found.velocity = (1 / weights) * velocities;
        // The integral over a full ball is 0.15 r^2.
        const double scale = 1 / (0.15 * double(reach_) * double(reach_));
        const double s[] = {double(shift.x), double(shift.y), double(shift.z)};
        constexpr std::size_t place[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b)
                found.covariance[a][b] =
                    scale * (double(products[place[a][b]]) / double(weights) - s[a] * s[b]);
        }
        return found;
    }

private:
    float reach_;
    Grid grid_;
    const Tank& tank_;
    std::vector<Vec3> position_, velocity_;
    std::vector<int> id_;
};

// The lengths of a kernel's half axes as parts of h, Eq. 15. The paper's step at N_eps neighbours
// would be seen to pop, and is a slope here.
std::array<double, 3> half_axes(std::array<double, 3> variance, int neighbours,
                                const SurfaceSettings& settings) {
    const double most = std::max({variance[0], variance[1], variance[2]});
    const double crowd = std::clamp(
        double(neighbours - settings.few) / double(settings.enough - settings.few), 0.0, 1.0);
    std::array<double, 3> axes{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double stretched = std::max(variance[k], most / double(settings.most_stretch));
        axes[k] = crowd * stretched + (1 - crowd) * double(settings.alone);
    }
    return axes;
}

} // namespace

std::vector<Blob> blobs_of(const Fluid& fluid, const SurfaceSettings& settings) {
    const float spacing = fluid.settings().spacing;
    const double h = double(settings.kernel * spacing);
    const double volume = double(spacing) * double(spacing) * double(spacing);
    // The integral of (1 - r^2)^3 over the unit ball: 4 pi (1/3 - 3/5 + 3/7 - 1/9).
    constexpr double integral = 64 * std::numbers::pi / 315;
    const Gatherer gatherer(fluid, settings.reach * spacing);
    std::vector<Blob> blobs(gatherer.count());
    for_all(gatherer.count(), fluid.settings().threads, [&](std::size_t i) {
        const Neighbourhood near = gatherer.gather(i);
        const Axes axes = axes_of(near.covariance);
        const std::array<double, 3> half = half_axes(axes.length, near.count, settings);
        Blob blob{};
        const float lambda = settings.smoothing; // Eq. 6
        blob.centre = (1 - lambda) * gatherer.position(i) + lambda * near.mean;
        blob.velocity = (1 - lambda) * gatherer.velocity(i) + lambda * near.velocity;
        std::size_t at = 0; // Eq. 16: the inverse of the stretched ball of radius h
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = a; b < 3; ++b) {
                double sum = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    sum += axes.columns[a][k] * axes.columns[b][k] / (h * half[k]);
                blob.g[at++] = float(sum);
            }
        }
        blob.weight = float(volume / (integral * h * h * h * half[0] * half[1] * half[2]));
        blobs[std::size_t(gatherer.id(i))] = blob;
    });
    return blobs;
}

} // namespace water
