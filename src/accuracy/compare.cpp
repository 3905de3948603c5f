#include "accuracy/compare.h"

#include <algorithm>
#include <cmath>

#include "roots/nearest.h"
#include "roots/tube.h"

namespace isomotion::accuracy {
namespace {

glm::dvec3 vector_of(const image::Frame& frame, const char* x, const char* y, const char* z,
                     std::size_t pixel) {
    return {frame.find(x)->samples[pixel], frame.find(y)->samples[pixel],
            frame.find(z)->samples[pixel]};
}

bool is_hit(render::Verdict verdict) {
    return verdict == render::Verdict::hit || verdict == render::Verdict::zero_gradient;
}

// Whether what was proved of a pixel contradicts what is certain of its ray. A proof tells more
// than judge() asks: its root is within an eighth of the pixel's width of where it was drawn, and
// twice that is left to the rounding of positions.
bool contradicts(render::Proof proof, bool hit, Fault fault, const roots::FirstRoot& root, double t,
                 double footprint) {
    if (!render::is_proved(proof)) return false;
    if ((proof == render::Proof::hit) != hit) return true; // of another ending than is drawn
    if (fault == Fault::undecided) return false;
    if (fault != Fault::none) return true;
    return proof == render::Proof::hit && root.answer == roots::Answer::hit &&
           (t < double(root.low) - 0.25 * footprint || t > double(root.high) + 0.25 * footprint);
}

} // namespace

void Errors::add(const Errors& other) {
    pixels += other.pixels;
    rays += other.rays;
    missed += other.missed;
    false_hits += other.false_hits;
    wrong_roots += other.wrong_roots;
    undecided += other.undecided;
    nan += other.nan;
    step_limit += other.step_limit;
    for (std::size_t k = 0; k < proofs.size(); ++k) proofs[k] += other.proofs[k];
    contradicted += other.contradicted;
    for (const auto& [mine, theirs] : {std::pair{&depth, &other.depth}, {&normal, &other.normal}}) {
        const auto middle = std::ptrdiff_t(mine->size());
        mine->insert(mine->end(), theirs->begin(), theirs->end());
        std::inplace_merge(mine->begin(), mine->begin() + middle, mine->end());
    }
}

double quantile(const std::vector<float>& sorted, double part) {
    if (sorted.empty()) return 0;
    return double(sorted[std::size_t(part * double(sorted.size() - 1) + 0.5)]);
}

namespace {

// Whether another surface was drawn than the one that certainly is the first.
bool is_of_another_surface(const image::Channel* surfaces, std::size_t pixel,
                           const roots::FirstRoot& root) {
    return surfaces && root.answer == roots::Answer::hit && root.surface >= 0 &&
           int(surfaces->samples[pixel]) != root.surface + 1;
}

} // namespace

Errors compare(const scene::SceneAt& now, const image::Frame& drawn, const roots::Truth& truth) {
    const roots::RaysOfSurfaces rays(now, truth.width, truth.height);
    const roots::Tubes& tubes = rays.of(0);
    const image::Channel* surfaces = drawn.find("surface");
    const image::Channel* proofs = drawn.find("proof");
    Errors errors;
    errors.pixels = std::int64_t(truth.width) * truth.height;
    errors.faults.resize(truth.roots.size());
    for (std::size_t pixel = 0; pixel < truth.roots.size(); ++pixel) {
        const roots::FirstRoot& root = truth.roots[pixel];
        const int column = int(pixel % std::size_t(truth.width));
        const int row = int(pixel / std::size_t(truth.width));
        const roots::Tube tube = tubes.at(column, row);
        bool meets_bounds = tube.near <= tube.far;
        for (std::size_t k = 1; k < rays.surfaces() && !meets_bounds; ++k) {
            const roots::Tube other = rays.of(k).at(column, row);
            meets_bounds = other.near <= other.far;
        }
        errors.rays += meets_bounds;
        const auto verdict = render::Verdict(int(drawn.find("verdict")->samples[pixel]));
        errors.nan += verdict == render::Verdict::nan;
        errors.step_limit += verdict == render::Verdict::step_limit;
        const bool hit = is_hit(verdict);
        double t = 0;
        if (hit) {
            const glm::dvec3 p = vector_of(drawn, "P.X", "P.Y", "P.Z", pixel);
            t = glm::dot(now.surfaces.front().placement.to_local(p) - tube.anchor, tube.direction);
        }
        Fault fault = judge(root, hit, t, tube.footprint);
        if (hit && fault == Fault::none && is_of_another_surface(surfaces, pixel, root))
            fault = Fault::wrong_root;
        errors.faults[pixel] = fault;
        errors.missed += fault == Fault::missed;
        errors.false_hits += fault == Fault::false_hit;
        errors.wrong_roots += fault == Fault::wrong_root;
        errors.undecided += fault == Fault::undecided;
        if (proofs) {
            const auto proof = render::Proof(int(proofs->samples[pixel]));
            ++errors.proofs[std::size_t(proof)];
            errors.contradicted += contradicts(proof, hit, fault, root, t, tube.footprint);
        }
        if (!hit || fault != Fault::none || root.answer != roots::Answer::hit) continue;

        const double certain = 0.5 * (double(root.low) + double(root.high));
        errors.depth.push_back(float(std::abs(t - certain) / tube.footprint));
        glm::dvec3 gradient(root.gradient[0], root.gradient[1], root.gradient[2]);
        const glm::dvec3 normal = glm::transpose(now.surfaces.front().placement.rotate) *
                                  vector_of(drawn, "N.X", "N.Y", "N.Z", pixel);
        const double size = glm::length(gradient) * glm::length(normal);
        if (!(size > 0) || !std::isfinite(size)) continue;
        if (glm::dot(gradient, tube.direction) > 0) gradient = -gradient;
        // The angle by its tangent: the cosine of a small one has lost it.
        const double angle =
            std::atan2(glm::length(glm::cross(gradient, normal)), glm::dot(gradient, normal));
        errors.normal.push_back(float(glm::degrees(angle)));
    }
    std::sort(errors.depth.begin(), errors.depth.end());
    std::sort(errors.normal.begin(), errors.normal.end());
    return errors;
}

} // namespace isomotion::accuracy
