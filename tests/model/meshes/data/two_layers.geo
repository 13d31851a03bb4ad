// Two soil layers with an inclined right end. The two .msh files beside this one were made from it by gmsh 4.8.4:
//   gmsh -2 -format msh41 two_layers.geo -o two_layers_41.msh         and with -bin: two_layers_41_binary.msh
Point(1) = {0, 0, 0};   Point(2) = {1.5, 0, 0};   Point(3) = {1.5, 0.5, 0};
Point(4) = {0, 0.5, 0}; Point(5) = {1.2, 1.0, 0}; Point(6) = {0, 1.0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {3, 5}; Line(6) = {5, 6}; Line(7) = {6, 4};
Curve Loop(1) = {1, 2, 3, 4};   Plane Surface(1) = {1};
Curve Loop(2) = {-3, 5, 6, 7};  Plane Surface(2) = {2};
Physical Curve("bottom") = {1};
Physical Curve("left") = {4, 7};
Physical Curve("right", 20) = {2, 5};
Physical Curve("walls") = {4, 7, 2, 5};
Physical Surface("sand layer") = {1};
Physical Surface("clay") = {2};
Physical Surface("all") = {1, 2};
Transfinite Curve {1:7} = 3;
Transfinite Surface {1, 2};
Mesh.RecombineAll = 1;
