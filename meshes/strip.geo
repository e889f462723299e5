// Strip of film over a single beam, the bow of the exact benchmarks: the film
// in the plane z = 0, its middle in the origin, and a free line below its centre
// line, parallel to x and as long as the film. The ends are to be tied to the
// ends of the beam by rigid bodies. Without stand-off the beam lies in the film:
// then cells_across must be odd, or the two share vertices. Lengths in m.
DefineConstant[
  length = {40e-3, Name "Film/Length along x, pre-stretch times the film's (m)"},
  width = {40e-3, Name "Film/Width along y (m)"},
  stand_off = {10e-3, Name "Beam/Of the beam below the film (m)"},
  cells_along = {8, Name "Mesh/Cells along the film"},
  cells_across = {1, Name "Mesh/Cells across the film"},
  cells_beam = {40, Name "Mesh/Elements of the beam, rounded up to an even number"},
  order = {1, Name "Mesh/Order of the cells"}
];

end_x = length / 2;
side_y = width / 2;

Point(1) = {-end_x, -side_y, 0};
Point(2) = {end_x, -side_y, 0};
Point(3) = {end_x, side_y, 0};
Point(4) = {-end_x, side_y, 0};
Point(5) = {-end_x, 0, -stand_off};
Point(6) = {0, 0, -stand_off};
Point(7) = {end_x, 0, -stand_off};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {5, 6};
Line(6) = {6, 7};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Transfinite Curve {1, 3} = cells_along + 1;
Transfinite Curve {2, 4} = cells_across + 1;
Transfinite Curve {5, 6} = Ceil(cells_beam / 2) + 1;
Transfinite Surface {1};
Recombine Surface {1};

Physical Surface("film") = {1};
Physical Curve("side_front") = {1};
Physical Curve("end_right") = {2};
Physical Curve("side_back") = {3};
Physical Curve("end_left") = {4};
Physical Curve("beam") = {5, 6};

Physical Point("corner_left_front") = {1};
Physical Point("corner_right_front") = {2};
Physical Point("corner_right_back") = {3};
Physical Point("corner_left_back") = {4};
Physical Point("beam_left") = {5};
Physical Point("beam_middle") = {6};
Physical Point("beam_right") = {7};

Mesh.ElementOrder = order;
