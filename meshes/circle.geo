// Plane disc around the origin, with its rim named. A square block with bulging
// sides in the middle and four blocks around it keep the cells near the centre
// well shaped; a vertex lies in the centre. Lengths in m.
DefineConstant[
  radius = {20e-3, Name "Disc/Radius (m)"},
  cells_around = {2, Name "Mesh/Cells around an eighth of the rim"},
  cells_radial = {3, Name "Mesh/Cells between the middle block and the rim"},
  order = {2, Name "Mesh/Order of the cells"}
];

// Half the side of the middle block. The centres of the arcs that bound it lie
// two of these beyond the origin: its corners have 127 degrees, the two cells
// outside share the rest.
half = 0.36 * radius;

Point(1) = {0, 0, 0};
For side In {0 : 3}
  x = Cos(Pi / 4 + side * Pi / 2);
  y = Sin(Pi / 4 + side * Pi / 2);
  Point(10 + side) = {Sqrt(2) * half * x, Sqrt(2) * half * y, 0};
  Point(20 + side) = {radius * x, radius * y, 0};
  Point(30 + side) =
    {2 * half * Sin(side * Pi / 2), -2 * half * Cos(side * Pi / 2), 0};
  Line(30 + side) = {10 + side, 20 + side};
EndFor

For side In {0 : 3}
  next = (side + 1) % 4;
  Circle(10 + side) = {10 + side, 30 + side, 10 + next};
  Circle(20 + side) = {20 + side, 1, 20 + next};
EndFor

Curve Loop(5) = {10 : 13};
Plane Surface(5) = {5};
For side In {0 : 3}
  next = (side + 1) % 4;
  Curve Loop(1 + side) = {30 + side, 20 + side, -(30 + next), -(10 + side)};
  Plane Surface(1 + side) = {1 + side};
EndFor

Transfinite Curve {10 : 13, 20 : 23} = 2 * cells_around + 1;
Transfinite Curve {30 : 33} = cells_radial + 1;
Transfinite Surface {1 : 5};
Recombine Surface {1 : 5};

Physical Surface("film") = {1 : 5};
Physical Curve("rim") = {20 : 23};

Mesh.ElementOrder = order;
