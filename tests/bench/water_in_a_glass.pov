// animations/water_in_a_glass.toml at frame 30 for POV-Ray 3.7: the same two formulas, matter by Fresnel's laws, as
// many rays in a row (10) and as many samples of a pixel (16):
//
//     povray +Itests/bench/water_in_a_glass.pov +Ow.png +W256 +H256 +A0.0 +AM1 +R4 -J -D +WT2
//
// Its light has no radius, and its surroundings no map, both of which cost less than ours.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 10 adc_bailout 0.004 }
#declare SM = function(a,b,k) { min(a,b) - pow(max(k-abs(a-b),0),2)/(4*k) }
camera { perspective location <7*cos(radians(17))*cos(radians(30)), 7*cos(radians(17))*sin(radians(30)), 7*sin(radians(17))-0.1> sky z up z right x look_at <0,0,-0.1> angle 28 }
light_source { 100*<0.35,-0.25,1.3> color rgb 0.8 }
background { rgb 0.6 }
plane { z, -1.051 pigment { rgb <0.55,0.5,0.45> } }
#declare Wave=0.12; #declare Turn=2*pi*(30-1)/30/4;
isosurface { function { max(sqrt(x*x+y*y)-0.95, max(z-0.15-Wave*(x*cos(Turn)+y*sin(Turn))-0.25*Wave*cos(7*sqrt(x*x+y*y)-2*Turn), -0.83-z)) }
 contained_by { sphere { 0, 1.5 } } max_gradient 1.6 accuracy 0.0001 all_intersections
 pigment { rgbt <1,1,1,1> } finish { ambient 0 diffuse 0 specular 0.5 reflection { 0,1 fresnel on } conserve_energy } interior { ior 1.33 } }
isosurface { function { -SM(SM(1.05-sqrt(x*x+y*y), 1.05-abs(z), 0.1), -SM(0.92-sqrt(x*x+y*y), z+0.8, 0.2), 0.08) }
 contained_by { sphere { 0, 1.6 } } max_gradient 1.5 accuracy 0.0001 all_intersections
 pigment { rgbt <1,1,1,1> } finish { ambient 0 diffuse 0 specular 0.5 reflection { 0,1 fresnel on } conserve_energy } interior { ior 1.5 } }
