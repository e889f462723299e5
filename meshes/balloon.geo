// An eighth of a sphere around the origin, x, y, z > 0, normals outwards. The
// edges in the three planes of symmetry are named after the coordinate that
// vanishes there. Three blocks meet in the middle of the eighth. Lengths in m.
DefineConstant[
  radius = {20e-3, Name "Balloon/Radius (m)"},
  cells = {2, Name "Mesh/Cells along the side of a block"},
  order = {2, Name "Mesh/Order of the cells"}
];

diagonal = radius / Sqrt(2);
middle = radius / Sqrt(3);

Point(1) = {0, 0, 0};
Point(11) = {radius, 0, 0};
Point(12) = {0, radius, 0};
Point(13) = {0, 0, radius};
Point(21) = {0, diagonal, diagonal};
Point(22) = {diagonal, 0, diagonal};
Point(23) = {diagonal, diagonal, 0};
Point(31) = {middle, middle, middle};

Circle(1) = {12, 1, 21};
Circle(2) = {21, 1, 13};
Circle(3) = {13, 1, 22};
Circle(4) = {22, 1, 11};
Circle(5) = {11, 1, 23};
Circle(6) = {23, 1, 12};
Circle(7) = {21, 1, 31};
Circle(8) = {22, 1, 31};
Circle(9) = {23, 1, 31};

Curve Loop(1) = {5, 9, -8, 4};
Surface(1) = {1} In Sphere {1};
Curve Loop(2) = {1, 7, -9, 6};
Surface(2) = {2} In Sphere {1};
Curve Loop(3) = {3, 8, -7, 2};
Surface(3) = {3} In Sphere {1};

Transfinite Curve {1 : 9} = cells + 1;
Transfinite Surface {1 : 3};
Recombine Surface {1 : 3};

Physical Surface("film") = {1 : 3};
Physical Curve("symmetry_x") = {1, 2};
Physical Curve("symmetry_y") = {3, 4};
Physical Curve("symmetry_z") = {5, 6};
Physical Point("pole_x") = {11};
Physical Point("pole_y") = {12};
Physical Point("pole_z") = {13};

Mesh.ElementOrder = order;
