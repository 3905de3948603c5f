#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grid.h"
#include "kernels.h"
#include "tank.h"

namespace water {

struct Settings {
    float spacing;        // between particles at rest
    float gravity = 1.5F; // downwards, per second squared
    // Surface tension of Akinci, Akinci & Teschner 2013: their gamma, of the force that pulls
    // together with the density at rest in it, and of the one that makes surfaces small.
    float cohesion = 9, contraction = 0.05F;
    float viscosity = 10;  // XSPH: the part of the neighbours' velocity taken on in a second
    float friction = 1;    // the same of a wall's
    float air = 1.5F;      // of spray: the part of its speed lost to the air on a way of 1
    float parting = 0.03F; // seconds in which particles too close come apart
    unsigned threads = 1;  // do not change the result
};

/// Water of particles of one mass, kept incompressible as in Bender & Koschier, "Divergence-free
/// SPH for incompressible and viscous fluids", TVCG 2017: before each step pressures make the
/// velocities free of divergence, and after the other forces pressures make the density of the
/// next step that of rest. Densities are fractions of the density at rest.
class Fluid {
public:
    Fluid(Tank tank, const Settings& settings, std::vector<Vec3> positions,
          std::vector<Vec3> velocities);

    /// Moves particles apart where they are too close, and leaves all with the velocities they had:
    /// else what a first state has wrong would fly apart.
    void settle(int steps);

    void advance(float seconds);

    /// In an order of its own that changes; ids() tells which is which.
    std::span<const Vec3> positions() const { return position_; }
    std::span<const Vec3> velocities() const { return velocity_; }
    std::span<const float> densities() const { return density_; } // of the last step
    std::span<const int> ids() const { return id_; }
    const Tank& tank() const { return tank_; }
    const Settings& settings() const { return settings_; }

    struct Work {
        long steps = 0, density_iterations = 0, divergence_iterations = 0;
    };
    const Work& work() const { return work_; }

private:
    struct Pair {
        std::uint32_t other;
        Vec3 slope; // V grad W, V the volume at rest
    };
    struct Row { // in the pairs of a particle's chunk
        std::uint32_t first, last;
    };

    void step(float dt);
    float longest_step() const;
    void sort_particles();
    void find_pairs();
    void add_forces(float dt);
    void move(float dt);
    /// Pressures, from those at hand, that make the velocities' density change by no more than
    /// `room` (of each particle, may be negative) within dt; adds their accelerations. Returns the
    /// number of iterations.
    int solve(float dt, std::span<const float> room, std::vector<float>& pressure, float tolerance,
              int most);
    std::span<const Pair> pairs(std::size_t i) const {
        const Row row = rows_[i];
        return std::span(chunk_pairs_[i / chunk()]).subspan(row.first, row.last - row.first);
    }
    static std::size_t chunk();
    /// The density's rate of change with these velocities, Eq. 3 without the limit.
    float rate(std::size_t i, std::span<const Vec3> velocity) const;

    Tank tank_;
    Settings settings_;
    Kernels kernels_;
    float volume_; // of a particle at rest
    Grid grid_, wall_grid_;
    std::vector<Vec3> wall_points_;

    std::vector<Vec3> position_, velocity_;
    std::vector<float> density_pressure_, divergence_pressure_; // over density squared
    std::vector<int> id_;

    std::vector<float> density_, wall_density_, diagonal_, room_;
    std::vector<Vec3> wall_slope_, acceleration_, normal_, change_;
    std::vector<std::uint8_t> crowded_;
    std::vector<Row> rows_;
    std::vector<std::vector<Pair>> chunk_pairs_;
    Work work_;
};

} // namespace water
