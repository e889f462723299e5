// A tapered finger: a film in a frame that is clamped at its wide end, drawn flat,
// as it is before it is let go. Lengths in m.
DefineConstant[
  length = {50e-3, Name "Finger/Length along x (m)"},
  root = {30e-3, Name "Finger/Width at the clamp (m)"},
  tip = {18e-3, Name "Finger/Width at the tip (m)"},
  cells_along = {12, Name "Mesh/Cells along the finger"},
  cells_across = {6, Name "Mesh/Cells across the finger"},
  order = {1, Name "Mesh/Order of the cells"}
];

Point(1) = {0, -root / 2, 0};
Point(2) = {length, -tip / 2, 0};
Point(3) = {length, tip / 2, 0};
Point(4) = {0, root / 2, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Transfinite Curve {1, 3} = cells_along + 1;
Transfinite Curve {2, 4} = cells_across + 1;
Transfinite Surface {1};
Recombine Surface {1};

// What the case file will speak of.
Physical Surface("film") = {1};
Physical Curve("sides") = {1, 3};
Physical Curve("tip") = {2};
Physical Curve("clamp") = {4};
Physical Point("leg_ends") = {1, 4};
Physical Point("tip_corner") = {3};

Mesh.ElementOrder = order;
