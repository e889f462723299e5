// Lee's frame: two legs of the same length in the plane y = 0 that meet in a
// rigid corner, a column along z from the origin and a beam along x. Free lines
// only, no film. Lengths in m.
DefineConstant[
  leg = {120, Name "Frame/Length of a leg (m)"},
  place = {24, Name "Frame/Of the load from the corner (m)"},
  cells = {8, Name "Mesh/Elements from the corner to the load"},
  order = {2, Name "Mesh/Order of the elements"}
];

Point(1) = {0, 0, 0};
Point(2) = {0, 0, leg};
Point(3) = {place, 0, leg};
Point(4) = {leg, 0, leg};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Transfinite Curve {1} = Ceil(cells * leg / place) + 1;
Transfinite Curve {2} = cells + 1;
Transfinite Curve {3} = Ceil(cells * (leg - place) / place) + 1;

Physical Curve("column") = {1};
Physical Curve("beam") = {2, 3};
Physical Point("foot") = {1};
Physical Point("corner") = {2};
Physical Point("place") = {3};
Physical Point("wall") = {4};

Mesh.ElementOrder = order;
