#include "catalogue.h"

namespace isomotion::formula {

const std::vector<CatalogueSurface>& catalogue() {
    static const std::vector<CatalogueSurface> surfaces{
        {"ding_dong", "x^2+y^2-(1-z)*z^2+a", {{"a", 0.0}}, 1.5},
        {"clebsch",
         "81*(x^3+y^3+z^3)-189*(x^2*(y+z)+y^2*(x+z)+z^2*(x+y))+54*x*y*z+126*(x*y+y*z+x*z"
         ")-9*(x^2+y^2+z^2)-9*(x+y+z)+1",
         {},
         1.0},
        {"cayley", "-5*(x^2*(y+z)+y^2*(x+z)+z^2*(x+y))+2*(x*y+y*z+x*z)", {}, 0.8},
        {"torus_quartic",
         "(x^2+y^2+z^2+R^2-r^2)^2-4*R^2*(x^2+y^2)",
         {{"R", 1.0}, {"r", 0.4}},
         1.65},
        {"nordstrand",
         "25*(x^3*(y+z)+y^3*(x+z)+z^3*(x+y))+50*(x^2*y^2+x^2*z^2+y^2*z^2)-125*(x^2*y*z+y"
         "^2*x*z+z^2*x*y)-4*(x*y+y*z+x*z)+60*x*y*z",
         {},
         0.75},
        {"cushion",
         "z^2*x^2-z^4-2*z*x^2+2*z^3+x^2-z^2-(x^2-z)^2-y^4-2*x^2*y^2-y^2*z^2+2*y^2*z+y^2",
         {},
         1.35},
        {"goursat",
         "x^4+y^4+z^4+a*(x^2+y^2+z^2)^2+b*(x^2+y^2+z^2)+c",
         {{"a", 0.0}, {"b", 0.0}, {"c", -1.0}},
         1.35},
        {"kummer", "x^4+y^4+z^4-x^2-y^2-z^2-x^2*y^2-x^2*z^2-y^2*z^2+1", {}, 2.0},
        {"miter", "4*x^2*(x^2+y^2+z^2)-y^2*(1-y^2-z^2)", {}, 1.05},
        {"cross_cap", "4*x^2*(x^2+y^2+z^2+z)+y^2*(y^2+z^2-1)", {}, 1.1},
        {"piriform", "x^4-x^3+y^2+z^2", {}, 1.05},
        {"tooth", "x^4+y^4+z^4-x^2-y^2-z^2", {}, 1.2},
        {"cassini", "((x+a)^2+y^2)*((x-a)^2+y^2)-z^4", {{"a", 1.0}}, 1.9},
        {"steiner", "x^2*y^2+x^2*z^2+y^2*z^2-2*x*y*z", {}, 1.25},
        {"tangle", "x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+c", {{"c", 11.8}}, 2.5},
        {"mitchell", "4*(x^4+(y^2+z^2)^2)+17*x^2*(y^2+z^2)-20*(x^2+y^2+z^2)+17", {}, 2.1},
        {"peninsula", "x^2+y^3+z^5-c", {{"c", 1.0}}, 1.5},
        {"kiss", "x^2+y^2-(1-z)*z^4", {}, 1.45},
        {"dervish",
         "a = sqrt(5-sqrt(5)); 64*(x-1)*(x^4-4*x^3-10*x^2*y^2-4*x^2+16*x-20*x*y^2+5*y^4+"
         "16-20*y^2)-5*a*(2*z-a)*(4*(x^2+y^2-z^2)+(1+3*sqrt(5)))^2",
         {},
         5.0},
        {"teardrop", "0.5*x^5+0.5*x^4-y^2-z^2", {}, 1.05},
        {"barth_sextic",
         "phi = (1+sqrt(5))/2; 4*(phi^2*x^2-y^2)*(phi^2*y^2-z^2)*(phi^2*z^2-x^2)-alpha*("
         "1+2*phi)*(x^2+y^2+z^2-1)^2",
         {{"alpha", 1.0}},
         2.0},
        {"hunt", "4*(x^2+y^2+z^2-13)^3+27*(3*x^2+y^2-4*z^2-12)^2", {}, 3.65},
        {"klein_bottle",
         "(x^2+y^2+z^2+2*y-1)*((x^2+y^2+z^2-2*y-1)^2-8*z^2)+16*x*z*(x^2+y^2+z^2-2*y-1)",
         {},
         4.1},
        {"chmutov_6", "chebyshev(6,x)+chebyshev(6,y)+chebyshev(6,z)+c", {{"c", 0.0}}, 1.08},
        {"heart", "(2*x^2+2*y^2+z^2-1)^3-a*x^2*z^3-y^2*z^3", {{"a", 0.1}}, 1.4},
        {"high_silhouette", "x^6-y^6-2*x^3*y+y^2", {}, 1.5},
        {"chmutov_7", "chebyshev(7,x)+chebyshev(7,y)+chebyshev(7,z)+c", {{"c", 1.0}}, 1.1},
        {"labs_septic",
         "alpha = pow(sqrt(1/196+1/27)-1/14,1/3)-pow(sqrt(1/196+1/27)+1/14,1/3); a1 = -1"
         "2/7*alpha^2-384/49*alpha-8/7; a2 = -32/7*alpha^2+24/49*alpha-4; a3 = -4*alpha^"
         "2+24/49*alpha-4; a4 = -8/7*alpha^2+8/49*alpha-8/7; a5 = 49*alpha^2-7*alpha+50;"
         " x^7-21*x^5*y^2+35*x^3*y^4-7*x*y^6+7*z*((x^2+y^2)^3-8*z^2*(x^2+y^2)^2+16*z^4*("
         "x^2+y^2))-64*z^7-(z+a5)*((z+1)*(x^2+y^2)+a1*z^3+a2*z^2+a3*z+a4)^2",
         {},
         2.0},
        {"nonisol", "x^8-y^8-2*x^4*y+y^2", {}, 1.5},
        {"endrass_octic",
         "s = -sqrt(2); 64*(x^2-1)*(y^2-1)*((x+y)^2-2)*((x-y)^2-2)-(-4*(1+s)*(x^2+y^2)^2"
         "+(8*(2+s)*z^2+2*(2+7*s))*(x^2+y^2)-16*z^4+8*(1-2*s)*z^2-(1+12*s))^2",
         {},
         3.3},
        {"chmutov_9", "chebyshev(9,x)+chebyshev(9,y)+chebyshev(9,z)+c", {{"c", 1.0}}, 1.06},
        {"barth_decic",
         "phi = (1+sqrt(5))/2; 8*(x^2-phi^4*y^2)*(y^2-phi^4*z^2)*(z^2-phi^4*x^2)*(x^4+y^"
         "4+z^4-2*x^2*y^2-2*x^2*z^2-2*y^2*z^2)+alpha*(3+5*phi)*(x^2+y^2+z^2-1)^2*(x^2+y^"
         "2+z^2-2+phi)^2",
         {{"alpha", 1.0}},
         2.0},
        {"chmutov_14", "chebyshev(14,x)+chebyshev(14,y)+chebyshev(14,z)+c", {{"c", 0.0}}, 1.017},
        {"chmutov_50", "chebyshev(50,x)+chebyshev(50,y)+chebyshev(50,z)+c", {{"c", 0.0}}, 1.004},
        {"torus", "(c-sqrt(x^2+y^2))^2+z^2-a^2", {{"c", 1.0}, {"a", 0.4}}, 1.65, Kink::axis},
        {"blobby", "x^2+y^2+z^2+sin(k*x)-cos(k*y)+sin(k*z)-c", {{"k", 4.0}, {"c", 1.0}}, 2.05},
        {"scherk", "exp(z)*cos(y)-cos(x)", {}, 6.283},
        {"diamond",
         "sin(x)*sin(y)*sin(z)+sin(x)*cos(y)*cos(z)+cos(x)*sin(y)*cos(z)+cos(x)*cos(y)*s"
         "in(z)-c",
         {{"c", 0.0}},
         3.142},
        {"superquadric",
         "pow(abs(x),m)+pow(abs(y),m)+pow(abs(z),m)-1",
         {{"m", 0.7}},
         1.05,
         Kink::planes},
        {"twisted_superquadric",
         "pow(abs(x*cos(k*z)+y*sin(k*z)),m)+pow(abs(y*cos(k*z)-x*sin(k*z)),m)+pow(abs(z)"
         ",m)-1",
         {{"m", 6.0}, {"k", 1.570796}},
         1.42},
        {"kummer_tetrahedral",
         "lam = (3*mu^2-1)/(3-mu^2); (x^2+y^2+z^2-mu^2)^2-lam*(1-z-sqrt(2)*x)*(1-z+sqrt("
         "2)*x)*(1+z+sqrt(2)*y)*(1+z-sqrt(2)*y)",
         {{"mu", 1.3}},
         2.6},
        {"heart_taubin", "(x^2+9/4*y^2+z^2-1)^3-x^2*z^3-9/80*y^2*z^3", {}, 1.4},
        {"sarti_dodecic",
         "l1 = x^4 + y^4 + z^4 + 1; l2 = x^2*y^2 + z^2; l3 = x^2*z^2 + y^2; l4 = x^2 + y^2*z^2;"
         "l5 = x*y*z; s10 = l1*(l2*l3 + l2*l4 + l3*l4); s11 = l1^2*(l2 + l3 + l4);"
         "s12 = l1*(l2^2 + l3^2 + l4^2); s51 = l5^2*(l2 + l3 + l4); s234 = l2^3 + l3^3 + l4^3;"
         "p = l2^2*l3 + l2*l3^2 + l3^2*l4 + l3*l4^2 + l4^2*l2 + l4*l2^2;"
         "m = l2^2*l3 - l2*l3^2 + l3^2*l4 - l3*l4^2 + l4^2*l2 - l4*l2^2;"
         "243*(33*sqrt(5)*m + 19*p + 10*s234 - 14*s10 + 2*s11 - 6*s12 - 352*s51 + 336*l5^2*l1"
         "     + 48*l2*l3*l4 - lam*(x^2+y^2+z^2+1)^6)",
         {{"lam", 0.09053497942386832}},
         3},
        {"gaussian_blobs",
         "sum(balls, exp(-a*((x-cx)^2+(y-cy)^2+(z-cz)^2-R^2))) - T",
         {{"a", 32}, {"R", 0.25}, {"T", 1}},
         1.6},
        {"inverse_square_blobs",
         "sum(balls, R^2/((x-cx)^2+(y-cy)^2+(z-cz)^2)) - T",
         {{"R", 0.1}, {"T", 1}},
         1.6,
         Kink::centres},
        {"soft_blobs",
         "sum(balls, 1 - 4/9*min(1,((x-cx)^2+(y-cy)^2+(z-cz)^2)/R^2)^3"
         " + 17/9*min(1,((x-cx)^2+(y-cy)^2+(z-cz)^2)/R^2)^2"
         " - 22/9*min(1,((x-cx)^2+(y-cy)^2+(z-cz)^2)/R^2)) - T",
         {{"R", 0.45}, {"T", 0.5}},
         1.6},
    };
    return surfaces;
}

CatalogueField::CatalogueField(const CatalogueSurface& surface) {
    Vocabulary vocabulary;
    for (const auto& [name, value] : surface.parameters) {
        vocabulary.parameters.push_back(name);
        bindings.parameters.push_back(value);
    }
    vocabulary.arrays = {{"balls", {{"cx", {}}, {"cy", {}}, {"cz", {}}}}};
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
