#include "fluid.h"

#include <algorithm>
#include <cmath>

#include "parallel.h"

namespace water {
namespace {

// Neighbours within 2 spacings: some 33.
constexpr float support = 2;

// The volume at which a lattice has the density 1.
float volume_at_rest(const Kernels& kernels) {
    float sum = 0;
    for (int k = -2; k <= 2; ++k) {
        for (int j = -2; j <= 2; ++j) {
            for (int i = -2; i <= 2; ++i)
                sum += kernels.value(std::sqrt(float(i * i + j * j + k * k)) / support);
        }
    }
    return 1 / sum;
}

Box with_margin(const Box& box, float margin) {
    const Vec3 m{margin, margin, margin};
    return {box.low - m, box.high + m};
}

template<class T> void reorder(std::vector<T>& values, std::span<const std::uint32_t> order) {
    std::vector<T> sorted(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = values[order[i]];
    values = std::move(sorted);
}

} // namespace

std::size_t Fluid::chunk() { return chunk_size; }

Fluid::Fluid(Tank tank, const Settings& settings, std::vector<Vec3> positions,
             std::vector<Vec3> velocities)
    : tank_(std::move(tank))
    , settings_(settings)
    , kernels_(support * settings.spacing)
    , volume_(volume_at_rest(kernels_))
    , grid_(tank_.inside, kernels_.support())
    , wall_grid_(with_margin(tank_.inside, kernels_.support()), kernels_.support())
    , wall_points_(tank_.wall_points(settings.spacing, kernels_.support()))
    , position_(std::move(positions))
    , velocity_(std::move(velocities)) {
    reorder(wall_points_, wall_grid_.sort(wall_points_));
    const std::size_t n = position_.size();
    for (std::size_t i = 0; i < n; ++i) id_.push_back(int(i));
    for (std::vector<float>* v :
         {&density_pressure_, &divergence_pressure_, &density_, &wall_density_, &diagonal_, &room_})
        v->resize(n);
    for (std::vector<Vec3>* v : {&wall_slope_, &acceleration_, &normal_, &change_}) v->resize(n);
    crowded_.resize(n);
    rows_.resize(n);
    chunk_pairs_.resize(chunks_of(n));
    sort_particles();
    find_pairs();
}

void Fluid::settle(int steps) {
    const float dt = 0.1F; // of no consequence, as no velocity stays
    for (int k = 0; k < steps; ++k) {
        sort_particles();
        find_pairs();
        const std::vector<Vec3> kept = velocity_;
        std::fill(velocity_.begin(), velocity_.end(), Vec3{});
        for (std::size_t i = 0; i < position_.size(); ++i) room_[i] = 1 - density_[i];
        solve(dt, room_, density_pressure_, 1e-4F, 20);
        move(dt);
        velocity_ = kept;
        std::fill(density_pressure_.begin(), density_pressure_.end(), 0.0F);
    }
    sort_particles();
    find_pairs();
}

void Fluid::advance(float seconds) {
    while (seconds > 0) {
        // Equal steps to the end.
        const float steps = std::ceil(seconds / longest_step());
        step(seconds / steps);
        seconds = steps > 1 ? seconds - seconds / steps : 0;
    }
}

// The condition of Courant, Friedrichs and Lewy: the fastest particle moves by a part of the
// spacing.
float Fluid::longest_step() const {
    float fastest = 0;
    for (const Vec3& v : velocity_) fastest = std::max(fastest, dot(v, v));
    const float falling = std::sqrt(settings_.spacing / settings_.gravity);
    return std::min(0.4F * settings_.spacing / std::max(std::sqrt(fastest), 1e-6F), 0.1F * falling);
}

// Algorithm 1 of the paper, begun where its loop finds neighbours. The pressures are found by
// relaxed Jacobi iterations on their sum (as in Ihmsen et al., "Implicit incompressible SPH", TVCG
// 2014, Eq. 12) in place of the paper's sum of corrections: sums stay positive, so that water does
// not stick together where it parts, and they begin from those of the last step.
void Fluid::step(float dt) {
    const std::size_t n = position_.size();
    sort_particles();
    find_pairs();
    // Eq. 7-9: particles in a crowd must not come closer; those of spray may.
    for (std::size_t i = 0; i < n; ++i) room_[i] = crowded_[i] ? 0 : 1;
    work_.divergence_iterations += solve(dt, room_, divergence_pressure_, 1e-3F, 20);
    add_forces(dt);
    // What is too dense already parts bit by bit: all at once, its speed would be that error over
    // dt, and every impact would end in a spray of single particles.
    const float part = std::min(1.0F, dt / settings_.parting);
    for (std::size_t i = 0; i < n; ++i)
        room_[i] = density_[i] > 1 ? part * (1 - density_[i]) : 1 - density_[i];
    work_.density_iterations += solve(dt, room_, density_pressure_, 1e-3F, 60);
    move(dt);
    ++work_.steps;
}

// Neighbours in space become neighbours in memory.
void Fluid::sort_particles() {
    const std::vector<std::uint32_t> order = grid_.sort(position_);
    reorder(position_, order);
    reorder(velocity_, order);
    reorder(density_pressure_, order);
    reorder(divergence_pressure_, order);
    reorder(id_, order);
}

void Fluid::find_pairs() {
    const float h = kernels_.support();
    for_chunks(position_.size(), settings_.threads,
               [&](std::size_t c, std::size_t first, std::size_t last) {
                   std::vector<Pair>& pairs = chunk_pairs_[c];
                   pairs.clear();
                   for (std::size_t i = first; i < last; ++i) {
                       const Vec3 p = position_[i];
                       const std::size_t begin = pairs.size();
                       float density = kernels_.value(0), wall_density = 0, squares = 0;
                       int neighbours = 0;
                       Vec3 slope, wall_slope;
                       grid_.visit_near(p, h, [&](std::size_t from, std::size_t to) {
                           for (std::size_t j = from; j < to; ++j) {
                               const Vec3 d = p - position_[j];
                               const float square = dot(d, d);
                               if (square >= h * h || j == i) continue;
                               const float q = std::sqrt(square) / h;
                               // Two in one place have no direction to part in.
                               const Vec3 g =
                                   q > 0 ? volume_ * kernels_.slope_by_distance(q) * d : Vec3{};
                               density += kernels_.value(q);
                               slope += g;
                               squares += dot(g, g);
                               pairs.push_back({std::uint32_t(j), g});
                           }
                       });
                       neighbours = int(pairs.size() - begin);
                       // Points of the walls count as water at rest, as in Akinci et al.,
                       // "Versatile rigid-fluid coupling for incompressible SPH", 2012, Eq. 6, of a
                       // lattice two deep.
                       if (tank_.depth_in_wall(p) > -h) {
                           wall_grid_.visit_near(p, h, [&](std::size_t from, std::size_t to) {
                               for (std::size_t j = from; j < to; ++j) {
                                   const Vec3 d = p - wall_points_[j];
                                   const float square = dot(d, d);
                                   if (square >= h * h || square == 0) continue;
                                   const float q = std::sqrt(square) / h;
                                   wall_density += kernels_.value(q);
                                   wall_slope += volume_ * kernels_.slope_by_distance(q) * d;
                                   ++neighbours;
                               }
                           });
                       }
                       rows_[i] = {std::uint32_t(begin), std::uint32_t(pairs.size())};
                       density_[i] = volume_ * (density + wall_density);
                       wall_density_[i] = volume_ * wall_density;
                       wall_slope_[i] = wall_slope;
                       // Eq. 5's denominator: how the rate changes with the particle's own
                       // pressure.
                       diagonal_[i] = dot(slope + wall_slope, slope + wall_slope) + squares;
                       crowded_[i] = neighbours >= 20;
                   }
               });
}

float Fluid::rate(std::size_t i, std::span<const Vec3> velocity) const {
    const Vec3 v = velocity[i];
    float sum = dot(v, wall_slope_[i]);
    for (const Pair& pair : pairs(i)) sum += dot(v - velocity[pair.other], pair.slope);
    return sum;
}

int Fluid::solve(float dt, std::span<const float> room, std::vector<float>& pressure,
                 float tolerance, int most) {
    const std::size_t n = position_.size();
    const float least = 1e-3F / (kernels_.support() * kernels_.support());
    std::vector<float> wanted(n), error(n), next(n); // wanted: a rate of change
    for_all(n, settings_.threads,
            [&](std::size_t i) { wanted[i] = (room[i] - dt * rate(i, velocity_)) / (dt * dt); });
    const auto accelerate = [&] {
        for_all(n, settings_.threads, [&](std::size_t i) { // Eq. 6
            const float p = pressure[i];
            Vec3 sum = p * wall_slope_[i];
            for (const Pair& pair : pairs(i)) sum += (p + pressure[pair.other]) * pair.slope;
            change_[i] = -1 * sum;
        });
    };
    int iteration = 0;
    for (bool close = false; !close && iteration < most; ++iteration) {
        accelerate();
        for_all(n, settings_.threads, [&](std::size_t i) {
            const float missing = wanted[i] - rate(i, change_);
            next[i] = diagonal_[i] > least
                          ? std::max(0.0F, pressure[i] - 0.5F * missing / diagonal_[i])
                          : 0;
            // Too much room is no error where nothing presses.
            error[i] = next[i] > 0 || missing < 0 ? std::abs(missing) : 0;
        });
        double sum = 0; // in one order
        for (const float e : error) sum += double(e);
        close = iteration >= 1 && sum * double(dt) * double(dt) <= double(tolerance) * double(n);
        std::swap(pressure, next);
    }
    accelerate();
    for (std::size_t i = 0; i < n; ++i) velocity_[i] += dt * change_[i];
    return iteration;
}

void Fluid::add_forces(float dt) {
    const std::size_t n = position_.size();
    const float h = kernels_.support();
    for_all(n, settings_.threads, [&](std::size_t i) {
        Vec3 sum; // Akinci, Akinci & Teschner 2013, Eq. 4, with what a wall would add
        for (const Pair& pair : pairs(i)) sum += (1 / density_[pair.other]) * pair.slope;
        normal_[i] = h * (sum + wall_slope_[i]);
    });
    const float mix = std::min(0.5F, settings_.viscosity * dt);
    for_all(n, settings_.threads, [&](std::size_t i) {
        Vec3 pull, drift;
        for (const Pair& pair : pairs(i)) {
            const std::size_t j = pair.other;
            const Vec3 d = position_[i] - position_[j];
            const float r = length(d), q = r / h;
            if (r == 0) continue;
            const float both = 2 / (density_[i] + density_[j]);
            // Their Eq. 1, 3 and 5.
            const float cohesion = settings_.cohesion * volume_ * kernels_.cohesion(q) / r;
            pull -= both * (cohesion * d + settings_.contraction * (normal_[i] - normal_[j]));
            // XSPH, Macklin & Müller 2013, Eq. 17.
            drift += both * volume_ * kernels_.value(q) * (velocity_[j] - velocity_[i]);
        }
        const float drag = std::min(0.5F, settings_.friction * dt) * wall_density_[i];
        acceleration_[i] = pull - Vec3{0, 0, settings_.gravity};
        const float spray = std::max(0.0F, 1 - float(pairs(i).size()) / 20);
        const float air = std::min(0.5F, settings_.air * dt * spray * length(velocity_[i]));
        change_[i] = mix * drift - (drag + air) * velocity_[i];
    });
    for (std::size_t i = 0; i < n; ++i) velocity_[i] += dt * acceleration_[i] + change_[i];
}

void Fluid::move(float dt) {
    const float margin = 0.25F * settings_.spacing;
    for (std::size_t i = 0; i < position_.size(); ++i) {
        Vec3& p = position_[i];
        Vec3& v = velocity_[i];
        p += dt * v;
        // Pressure keeps water out of the walls; what a fast particle passes, this gives back.
        if (tank_.depth_in_wall(p) < -margin) continue;
        for (const Wall& wall : tank_.walls_near(p, margin)) {
            p += (margin - wall.distance(p)) * wall.normal;
            v -= std::min(0.0F, dot(v, wall.normal)) * wall.normal;
        }
    }
}

} // namespace water
