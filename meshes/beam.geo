// Beam without a film: a straight line along x from the origin, or an arc of the
// plane z = 0 that starts along x and bends towards y. Lengths in m.
DefineConstant[
  length = {0.1, Name "Beam/Length (m)"},
  angle = {0, Name "Beam/Angle of the arc, below 360, or 0 for a straight beam (degrees)"},
  cells = {10, Name "Mesh/Elements, rounded up to an even number"},
  order = {2, Name "Mesh/Order of the elements"}
];

If (angle == 0)
  Point(1) = {0, 0, 0};
  Point(2) = {length / 2, 0, 0};
  Point(3) = {length, 0, 0};
  Line(1) = {1, 2};
  Line(2) = {2, 3};
Else
  turn = angle * Pi / 180;
  radius = length / turn;
  For i In {0 : 2}
    Point(1 + i) = {radius * Sin(i * turn / 2), radius * (1 - Cos(i * turn / 2)), 0};
  EndFor
  Point(4) = {0, radius, 0};
  Circle(1) = {1, 4, 2};
  Circle(2) = {2, 4, 3};
EndIf
Transfinite Curve {1, 2} = Ceil(cells / 2) + 1;

Physical Curve("beam") = {1, 2};
Physical Point("start") = {1};
Physical Point("middle") = {2};
Physical Point("end") = {3};

Mesh.ElementOrder = order;
