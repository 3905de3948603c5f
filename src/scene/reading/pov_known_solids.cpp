#include "scene/reading/pov_known_solids.h"

#include <algorithm>
#include <string_view>

namespace isomotion::scene {
namespace {

struct KnownSolid {
    std::string_view name;
    const char* formula; // of our x, y and z: POV-Ray's x, z and y
    enum class Extent { unknown, closed, endless } extent = Extent::unknown;
};

constexpr auto closed = KnownSolid::Extent::closed, endless = KnownSolid::Extent::endless;

constexpr KnownSolid known_solids[] = {
    // shapes.inc
    {"Sphere", "x^2 + y^2 + z^2 - 1", closed},
    {"Ellipsoid", "x^2 + y^2 + z^2 - 1", closed},
    {"Cube", "max(abs(x) - 1, abs(y) - 1, abs(z) - 1)", closed},
    {"UnitBox", "max(abs(x) - 1, abs(y) - 1, abs(z) - 1)", closed},
    {"Cylinder_X", "y^2 + z^2 - 1", endless},
    {"Cylinder_Y", "x^2 + y^2 - 1", endless},
    {"Cylinder_Z", "x^2 + z^2 - 1", endless},
    {"Disk_X", "max(y^2 + z^2 - 1, abs(x) - 1)", closed},
    {"Disk_Y", "max(x^2 + y^2 - 1, abs(z) - 1)", closed},
    {"Disk_Z", "max(x^2 + z^2 - 1, abs(y) - 1)", closed},
    {"QCone_X", "y^2 + z^2 - x^2", endless},
    {"QCone_Y", "x^2 + y^2 - z^2", endless},
    {"QCone_Z", "x^2 + z^2 - y^2", endless},
    {"Cone_X", "max(length(y, z) - (1 - x)/2, abs(x) - 1)", closed},
    {"Cone_Y", "max(length(x, y) - (1 - z)/2, abs(z) - 1)", closed},
    {"Cone_Z", "max(length(x, z) - (1 - y)/2, abs(y) - 1)", closed},
    {"Plane_YZ", "x", endless},
    {"Plane_XZ", "z", endless},
    {"Plane_XY", "y", endless},
    {"Paraboloid_X", "y^2 + z^2 - x", endless},
    {"Paraboloid_Y", "x^2 + y^2 - z", endless},
    {"Paraboloid_Z", "x^2 + z^2 - y", endless},
    {"Hyperboloid", "y^2 - x^2 + z", endless},
    {"Hyperboloid_Y", "x^2 + y^2 - z^2 - 1", endless},
    // shapesq.inc
    {"Bicorn", "(x^2 + y^2 + 2*z - 1)^2 + (x^2 + y^2 - 1)*z^2"},
    {"Crossed_Trough", "4*x^2*y^2 - z"},
    {"Cubic_Cylinder", "y^2 + z^2 - 0.5*x^3 - 0.5*x^2"},
    {"Cubic_Saddle_1", "x^3 - z^3 - y"},
    {"Devils_Curve", "z^4 - 0.25*z^2 - (x^2 + y^2)^2 + 0.36*x^2"},
    {"Folium", "2*x^2 + (1 - 3*x)*(y^2 + z^2)"},
    {"Glob_5", "y^2 + z^2 - 0.5*x^5 - 0.5*x^4"},
    {"Twin_Glob", "4*x^6 - 4*x^4 + y^2 + z^2", closed},
    {"Helix", "if(max(x^2 + z^2 - 4, y - 1.4142, -y) < 0, "
              "x*y - 0.1666*x*y^3 + 0.5*y^2*z - z, 1)"},
    {"Helix_1", "if(max(x^2 + z^2 - 4, y - 1.4142, -y) < 0, "
                "x*y - 0.1666*x*y^3 + 0.5*y^2*z - z, 1)"},
    {"Hyperbolic_Torus_40_12", "(x^2 - y^2 + z^2)^2 - 104*x^2 + 104*y^2 + 56*z^2 + 784"},
    {"Lemniscate", "x^4 - x^2 + y^2 + z^2", closed},
    {"Quartic_Loop_1", "99*x^4 - 40*x^3 - 99*x^2 + (98*x^2 - 40*x + 1)*(y^2 + z^2) - "
                       "(y^2 + z^2)^2"},
    {"Monkey_Saddle", "x^3 - 3*x*z^2 - y"},
    {"Parabolic_Torus_40_12", "(x^2 - y + z^2)^2 - 104*x^2 + 104*y + 56*z^2 + 784"},
    {"Piriform", "4*x^4 - 4*x^3 + y^2 + z^2", closed},
    {"Quartic_Paraboloid", "0.1*x^4 - x^2 - y^2 - z + 0.9"},
    {"Quartic_Cylinder", "(x^2 + y^2)*(z^2 + 0.01) - 0.01"},
    {"Steiner_Surface", "x^2*y^2 + y^2*z^2 + z^2*x^2 + x*y*z"},
    {"Torus_40_12", "(x^2 + y^2 + z^2)^2 - 104*x^2 - 104*y^2 + 56*z^2 + 784", closed},
    {"Witch_Hat", "z*(x^2 + y^2) + 0.04*z + 0.04"},
};

} // namespace

std::optional<PovSolid> known_pov_solid(const std::string& name) {
    const auto* const found = std::ranges::find(known_solids, name, &KnownSolid::name);
    if (found == std::end(known_solids)) return std::nullopt;
    PovSolid solid;
    solid.word = name;
    solid.formula = found->formula;
    solid.is_closed = found->extent == closed;
    solid.is_endless = found->extent == endless;
    solid.take_looks();
    if (name == "Cube" || name == "UnitBox")
        solid.shape = PovBounds{0, "{ box = [[-1, -1, -1], [1, 1, 1]] }", solid.formula};
    if (name == "Sphere" || name == "Ellipsoid")
        solid.shape = PovBounds{0, "{ sphere = 1, centre = [0, 0, 0] }", solid.formula};
    return solid;
}

} // namespace isomotion::scene
