// Rectangular sheet in the plane z = 0, with its four edges named. Lengths in m.
DefineConstant[
  length = {20e-3, Name "Sheet/Length along x (m)"},
  width = {20e-3, Name "Sheet/Width along y (m)"},
  cells_x = {4, Name "Mesh/Cells along x"},
  cells_y = {4, Name "Mesh/Cells along y"},
  order = {1, Name "Mesh/Order of the cells"}
];

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, width, 0};
Point(4) = {0, width, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Transfinite Curve {1, 3} = cells_x + 1;
Transfinite Curve {2, 4} = cells_y + 1;
Transfinite Surface {1};
Recombine Surface {1};

Physical Surface("film") = {1};
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};

// The corners, to hold or to probe a single point.
Physical Point("bottom_left") = {1};
Physical Point("bottom_right") = {2};
Physical Point("top_right") = {3};
Physical Point("top_left") = {4};

Mesh.ElementOrder = order;
