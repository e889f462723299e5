// Plane ring around the origin, with both rims named. Lengths in m.
DefineConstant[
  inner_radius = {5e-3, Name "Ring/Inner radius (m)"},
  outer_radius = {20e-3, Name "Ring/Outer radius (m)"},
  cells_around = {4, Name "Mesh/Cells around a quarter"},
  cells_radial = {4, Name "Mesh/Cells from rim to rim"},
  order = {2, Name "Mesh/Order of the cells"}
];

Point(1) = {0, 0, 0};
For quarter In {0 : 3}
  x = Cos(quarter * Pi / 2);
  y = Sin(quarter * Pi / 2);
  Point(10 + quarter) = {inner_radius * x, inner_radius * y, 0};
  Point(20 + quarter) = {outer_radius * x, outer_radius * y, 0};
  Line(30 + quarter) = {10 + quarter, 20 + quarter};
EndFor

For quarter In {0 : 3}
  next = (quarter + 1) % 4;
  Circle(10 + quarter) = {10 + quarter, 1, 10 + next};
  Circle(20 + quarter) = {20 + quarter, 1, 20 + next};
EndFor

For quarter In {0 : 3}
  next = (quarter + 1) % 4;
  Curve Loop(1 + quarter) =
    {30 + quarter, 20 + quarter, -(30 + next), -(10 + quarter)};
  Plane Surface(1 + quarter) = {1 + quarter};
EndFor

Transfinite Curve {10 : 13, 20 : 23} = cells_around + 1;
Transfinite Curve {30 : 33} = cells_radial + 1;
Transfinite Surface {1 : 4};
Recombine Surface {1 : 4};

Physical Surface("film") = {1 : 4};
Physical Curve("inner_rim") = {10 : 13};
Physical Curve("outer_rim") = {20 : 23};

Mesh.ElementOrder = order;
