#include "unit/surface_formulas.h"

namespace isomotion {

const std::vector<SurfaceFormula>& surface_formulas() {
    static const std::vector<SurfaceFormula> formulas{
        {"ding_dong", "x^2+y^2-(1-z)*z^2+a", {{"a", 0.0}}, 1.5},
        {"clebsch",
         "81*(x^3+y^3+z^3)-189*(x^2*(y+z)+y^2*(x+z)+z^2*(x+y))+54*x*y*z+126*(x*y+y*z+x*z)-"
         "9*(x^2+y^2+z^2)-9*(x+y+z)+1",
         {},
         1.0},
        {"cayley", "-5*(x^2*(y+z)+y^2*(x+z)+z^2*(x+y))+2*(x*y+y*z+x*z)", {}, 0.8},
        {"torus_quartic",
         "(x^2+y^2+z^2+R^2-r^2)^2-4*R^2*(x^2+y^2)",
         {{"R", 1.0}, {"r", 0.4}},
         1.65},
        {"nordstrand",
         "25*(x^3*(y+z)+y^3*(x+z)+z^3*(x+y))+50*(x^2*y^2+x^2*z^2+y^2*z^2)-125*(x^2*y*z+y^2"
         "*x*z+z^2*x*y)-4*(x*y+y*z+x*z)+60*x*y*z",
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
         "a = sqrt(5-sqrt(5)); 64*(x-1)*(x^4-4*x^3-10*x^2*y^2-4*x^2+16*x-20*x*y^2+5*y^4+16"
         "-20*y^2)-5*a*(2*z-a)*(4*(x^2+y^2-z^2)+(1+3*sqrt(5)))^2",
         {},
         5.0},
        {"teardrop", "0.5*x^5+0.5*x^4-y^2-z^2", {}, 1.05},
        {"barth_sextic",
         "phi = (1+sqrt(5))/2; 4*(phi^2*x^2-y^2)*(phi^2*y^2-z^2)*(phi^2*z^2-x^2)-alpha*(1+"
         "2*phi)*(x^2+y^2+z^2-1)^2",
         {{"alpha", 1.0}},
         2.0},
        {"hunt", "4*(x^2+y^2+z^2-13)^3+27*(3*x^2+y^2-4*z^2-12)^2", {}, 3.65},
        {"klein_bottle",
         "(x^2+y^2+z^2+2*y-1)*((x^2+y^2+z^2-2*y-1)^2-8*z^2)+16*x*z*(x^2+y^2+z^2-2*y-1)",
         {},
         4.1},
        {"chmutov_6", "chebyshev(6,x)+chebyshev(6,y)+chebyshev(6,z)+c", {{"c", 0.0}}, 1.07974},
        {"heart", "(2*x^2+2*y^2+z^2-1)^3-a*x^2*z^3-y^2*z^3", {{"a", 0.1}}, 1.4},
        {"high_silhouette", "x^6-y^6-2*x^3*y+y^2", {}, 1.5},
        {"chmutov_7", "chebyshev(7,x)+chebyshev(7,y)+chebyshev(7,z)+c", {{"c", 1.0}}, 1.1},
        {"labs_septic",
         "alpha = pow(sqrt(1/196+1/27)-1/14,1/3)-pow(sqrt(1/196+1/27)+1/14,1/3); a1 = -12/"
         "7*alpha^2-384/49*alpha-8/7; a2 = -32/7*alpha^2+24/49*alpha-4; a3 = -4*alpha^2+24"
         "/49*alpha-4; a4 = -8/7*alpha^2+8/49*alpha-8/7; a5 = 49*alpha^2-7*alpha+50; x^7-2"
         "1*x^5*y^2+35*x^3*y^4-7*x*y^6+7*z*((x^2+y^2)^3-8*z^2*(x^2+y^2)^2+16*z^4*(x^2+y^2)"
         ")-64*z^7-(z+a5)*((z+1)*(x^2+y^2)+a1*z^3+a2*z^2+a3*z+a4)^2",
         {},
         2.0},
        {"nonisol", "x^8-y^8-2*x^4*y+y^2", {}, 1.5},
        {"chmutov_8", "chebyshev(8,x)+chebyshev(8,y)+chebyshev(8,z)+c", {{"c", 0.0}}, 1.04593},
        {"endrass_octic",
         "s = -sqrt(2); 64*(x^2-1)*(y^2-1)*((x+y)^2-2)*((x-y)^2-2)-(-4*(1+s)*(x^2+y^2)^2+("
         "8*(2+s)*z^2+2*(2+7*s))*(x^2+y^2)-16*z^4+8*(1-2*s)*z^2-(1+12*s))^2",
         {},
         3.3},
        {"chmutov_9", "chebyshev(9,x)+chebyshev(9,y)+chebyshev(9,z)+c", {{"c", 1.0}}, 1.06},
        {"barth_decic",
         "phi = (1+sqrt(5))/2; 8*(x^2-phi^4*y^2)*(y^2-phi^4*z^2)*(z^2-phi^4*x^2)*(x^4+y^4+"
         "z^4-2*x^2*y^2-2*x^2*z^2-2*y^2*z^2)+alpha*(3+5*phi)*(x^2+y^2+z^2-1)^2*(x^2+y^2+z^"
         "2-2+phi)^2",
         {{"alpha", 1.0}},
         2.0},
        {"sarti_dodecic",
         "243*((33*sqrt(5)*((x^2*y^2+z^2)^2*(x^2*z^2+y^2)-(x^2*y^2+z^2)*(x^2*z^2+y^2)^2+(x"
         "^2*z^2+y^2)^2*(x^2+y^2*z^2)-(x^2*z^2+y^2)*(x^2+y^2*z^2)^2+(x^2+y^2*z^2)^2*(x^2*y"
         "^2+z^2)-(x^2+y^2*z^2)*(x^2*y^2+z^2)^2)+19*((x^2*y^2+z^2)^2*(x^2*z^2+y^2)+(x^2*y^"
         "2+z^2)*(x^2*z^2+y^2)^2+(x^2*z^2+y^2)^2*(x^2+y^2*z^2)+(x^2*z^2+y^2)*(x^2+y^2*z^2)"
         "^2+(x^2+y^2*z^2)^2*(x^2*y^2+z^2)+(x^2+y^2*z^2)*(x^2*y^2+z^2)^2)+10*((x^2*y^2+z^2"
         ")^3+(x^2*z^2+y^2)^3+(x^2+y^2*z^2)^3)-14*((x^4+y^4+z^4+1)*((x^2*y^2+z^2)*(x^2*z^2"
         "+y^2)+(x^2*y^2+z^2)*(x^2+y^2*z^2)+(x^2*z^2+y^2)*(x^2+y^2*z^2)))+2*((x^4+y^4+z^4+"
         "1)^2*((x^2*y^2+z^2)+(x^2*z^2+y^2)+(x^2+y^2*z^2)))-6*((x^4+y^4+z^4+1)*((x^2*y^2+z"
         "^2)^2+(x^2*z^2+y^2)^2+(x^2+y^2*z^2)^2))-352*((x*y*z)^2*((x^2*y^2+z^2)+(x^2*z^2+y"
         "^2)+(x^2+y^2*z^2)))+336*(x*y*z)^2*(x^4+y^4+z^4+1)+48*(x^2*y^2+z^2)*(x^2*z^2+y^2)"
         "*(x^2+y^2*z^2))-lam*((x^2+y^2+z^2+1)^6))",
         {{"lam", 0.09053497942386832}},
         3.0},
        {"chmutov_12", "chebyshev(12,x)+chebyshev(12,y)+chebyshev(12,z)+c", {{"c", 0.0}}, 1.02201},
        {"chmutov_14", "chebyshev(14,x)+chebyshev(14,y)+chebyshev(14,z)+c", {{"c", 0.0}}, 1.01695},
        {"chmutov_18", "chebyshev(18,x)+chebyshev(18,y)+chebyshev(18,z)+c", {{"c", 0.0}}, 1.01143},
        {"chmutov_22", "chebyshev(22,x)+chebyshev(22,y)+chebyshev(22,z)+c", {{"c", 0.0}}, 1.00864},
        {"chmutov_50", "chebyshev(50,x)+chebyshev(50,y)+chebyshev(50,z)+c", {{"c", 0.0}}, 1.00409},
        {"chmutov_14_trig",
         "chebyshev(14,x)+chebyshev(14,y)+chebyshev(14,z)+c",
         {{"c", 0.0}},
         1.01695},
        {"chmutov_18_trig",
         "chebyshev(18,x)+chebyshev(18,y)+chebyshev(18,z)+c",
         {{"c", 0.0}},
         1.01143},
        {"chmutov_22_trig",
         "chebyshev(22,x)+chebyshev(22,y)+chebyshev(22,z)+c",
         {{"c", 0.0}},
         1.00864},
        {"chmutov_50_trig",
         "chebyshev(50,x)+chebyshev(50,y)+chebyshev(50,z)+c",
         {{"c", 0.0}},
         1.00409},
        {"torus", "(c-sqrt(x^2+y^2))^2+z^2-a^2", {{"c", 1.0}, {"a", 0.4}}, 1.65},
        {"blobby", "x^2+y^2+z^2+sin(k*x)-cos(k*y)+sin(k*z)-c", {{"k", 4.0}, {"c", 1.0}}, 2.05},
        {"scherk", "exp(z)*cos(y)-cos(x)", {}, 6.28318},
        {"diamond",
         "sin(x)*sin(y)*sin(z)+sin(x)*cos(y)*cos(z)+cos(x)*sin(y)*cos(z)+cos(x)*cos(y)*sin"
         "(z)-c",
         {{"c", 0.0}},
         3.14159},
        {"superquadric", "pow(abs(x),m)+pow(abs(y),m)+pow(abs(z),m)-1", {{"m", 0.7}}, 1.05},
        {"twisted_superquadric",
         "pow(abs(x*cos(k*z)+y*sin(k*z)),m)+pow(abs(y*cos(k*z)-x*sin(k*z)),m)+pow(abs(z),m"
         ")-1",
         {{"m", 6.0}, {"k", 1.570796}},
         1.42},
        {"blinn_blobby",
         "sum(blobs, exp(-a*((x-s*ux)^2+(y-s*uy)^2+(z-s*uz)^2-R^2))) -T",
         {{"a", 32.0}, {"R", 0.25}, {"T", 1.0}, {"s", 1.0}},
         1.6},
        {"ding_dong_printed", "x^2+y^2-z*(1-z^2)", {}, 1.5},
        {"kiss_printed", "x^2+y^2-z*(1-z^4)", {}, 1.5},
        {"cassini_printed", "((x+a)^2+y^2)*((x-a)^2+y^2)-z^2", {{"a", 1.0}}, 1.9},
        {"miter_printed", "4*x^2*(x^2+y^2+z^2)-(1-y^2-z^2)", {}, 1.1},
        {"dervish_printed",
         "a = sqrt(5-sqrt(5)); 64*(x-1)*(x^4-4*x^3-10*x^2*y^2-4*x^2+16*x-20*x*y^2+5*y^4+16"
         "-20*y^2)-5*a*(2*z-a)*(4*(x^2+y^2+z^2)+(1+3*sqrt(5)))^2",
         {},
         5.0},
        {"endrass_octic_plus",
         "s = sqrt(2); 64*(x^2-1)*(y^2-1)*((x+y)^2-2)*((x-y)^2-2)-(-4*(1+s)*(x^2+y^2)^2+(8"
         "*(2+s)*z^2+2*(2+7*s))*(x^2+y^2)-16*z^4+8*(1-2*s)*z^2-(1+12*s))^2",
         {},
         4.0},
        {"kummer_tetrahedral",
         "lam = (3*mu^2-1)/(3-mu^2); (x^2+y^2+z^2-mu^2)^2-lam*(1-z-sqrt(2)*x)*(1-z+sqrt(2)"
         "*x)*(1+z+sqrt(2)*y)*(1+z-sqrt(2)*y)",
         {{"mu", 1.3}},
         2.6},
        {"labs_septic_chart_z",
         "alpha = pow(sqrt(1/196+1/27)-1/14,1/3)-pow(sqrt(1/196+1/27)+1/14,1/3); a1 = -12/"
         "7*alpha^2-384/49*alpha-8/7; a2 = -32/7*alpha^2+24/49*alpha-4; a3 = -4*alpha^2+24"
         "/49*alpha-4; a4 = -8/7*alpha^2+8/49*alpha-8/7; a5 = 49*alpha^2-7*alpha+50; x^7-2"
         "1*x^5*y^2+35*x^3*y^4-7*x*y^6+7*((x^2+y^2)^3-8*(x^2+y^2)^2+16*(x^2+y^2))-64-(1+a5"
         "*z)*((1+z)*(x^2+y^2)+a1+a2*z+a3*z^2+a4*z^3)^2",
         {},
         2.5},
        {"chmutov_8_nodal", "chebyshev(8,x)+chebyshev(8,y)+chebyshev(8,z)+1", {}, 1.06},
        {"heart_taubin", "(x^2+9/4*y^2+z^2-1)^3-x^2*z^3-9/80*y^2*z^3", {}, 1.4},
        {"high_silhouette_m5", "x^6-y^5-2*x^3*y+y^2", {}, 1.5},
        {"nonisol_m5", "x^8-y^5-2*x^4*y+y^2", {}, 1.5},
        {"nonisol_x2y", "x^8-y^8-2*x^2*y+y^2", {}, 1.5},
        {"blinn_inverse_square",
         "sum(blobs, R^2/((x-s*ux)^2+(y-s*uy)^2+(z-s*uz)^2)) -T",
         {{"R", 0.1}, {"T", 1.0}, {"s", 1.0}},
         1.6},
        {"wyvill_soft_objects",
         "sum(blobs, max(0, 1-4/9*min(1,((x-s*ux)^2+(y-s*uy)^2+(z-s*uz)^2)/R^2)^3+17/9*min"
         "(1,((x-s*ux)^2+(y-s*uy)^2+(z-s*uz)^2)/R^2)^2-22/9*min(1,((x-s*ux)^2+(y-s*uy)^2+("
         "z-s*uz)^2)/R^2))) -T",
         {{"R", 0.45}, {"T", 0.5}, {"s", 1.0}},
         1.6},
    };
    return formulas;
}

} // namespace isomotion
