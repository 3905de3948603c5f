#include "catalogue.h"

#include <map>

namespace isomotion::formula {

const std::vector<CatalogueSurface>& catalogue() {
    static const std::vector<CatalogueSurface> surfaces = [] {
        const std::map<std::string, Kink> kinks{{"torus", Kink::axis},
                                                {"superquadric", Kink::planes},
                                                {"blinn_inverse_square", Kink::centres}};
        std::vector<CatalogueSurface> all;
        for (const SurfaceFormula& formula : surface_formulas()) {
            const auto kink = kinks.find(formula.name);
            all.push_back({formula, kink == kinks.end() ? Kink::none : kink->second});
        }
        return all;
    }();
    return surfaces;
}

CatalogueField::CatalogueField(const CatalogueSurface& surface) {
    Vocabulary vocabulary;
    for (const auto& [name, value] : surface.parameters) {
        vocabulary.parameters.push_back(name);
        bindings.parameters.push_back(value);
    }
    vocabulary.arrays = {{"blobs", {{"ux", {}}, {"uy", {}}, {"uz", {}}}}};
    bindings.arrays = {{4, {{0, 0.5, -0.375, 0}, {0, 0.25, 0.5, -0.75}, {0, 0, -0.125, 0.25}}}};
    field = make_field(surface.text, vocabulary);
}

std::vector<Point> nasty_points(double reach) {
    std::vector<Point> points{{0, 0, 0}};
    for (const double s : {1.0, -1.0, 0.5, -0.5, reach, -reach}) {
        points.push_back({s, 0, 0});
        points.push_back({0, s, 0});
        points.push_back({0, 0, s});
        points.push_back({s, s, 0});
        points.push_back({0, s, -s});
        points.push_back({s, s, s});
    }
    return points;
}

bool at_kink(const CatalogueSurface& surface, const Point& p) {
    switch (surface.kink) {
    case Kink::none:
        return false;
    case Kink::axis:
        return p[0] == 0 && p[1] == 0;
    case Kink::planes:
        return p[0] == 0 || p[1] == 0 || p[2] == 0;
    case Kink::centres:
        return p == Point{0, 0, 0};
    }
    return false;
}

} // namespace isomotion::formula
