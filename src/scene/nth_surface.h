// The surfaces of a Scene, a SceneAt, or of what is made of them: each stands for its first surface
// and holds the others. Only this header knows so.
#pragma once

#include <cstddef>

namespace isomotion::scene {

template<class All> std::size_t surface_count(const All& all) { return 1 + all.others.size(); }
template<class All> bool has_several_surfaces(const All& all) { return !all.others.empty(); }

// In the file's order, from 0.
template<class All> All& nth_surface(All& all, std::size_t k) {
    return k == 0 ? all : all.others[k - 1];
}
template<class All> const All& nth_surface(const All& all, std::size_t k) {
    return k == 0 ? all : all.others[k - 1];
}

template<class All, class Visit> void for_each_surface(All& all, const Visit& visit) {
    for (std::size_t k = 0; k < surface_count(all); ++k) visit(nth_surface(all, k));
}

} // namespace isomotion::scene
