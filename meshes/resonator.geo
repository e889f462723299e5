// Membrane resonator: two strips of one film side by side in a rigid frame, the
// active one with electrodes, and a rigid bar on the line between them. Drawn in
// the framed shape, that is after the pre-stretch: lengths of the undeformed
// film times the stretch. x runs along the motion of the bar. Lengths in m.
DefineConstant[
  length_active = {20e-3, Name "Film/Undeformed length of the active strip (m)"},
  length_passive = {20e-3, Name "Film/Undeformed length of the passive strip (m)"},
  width = {20e-3, Name "Film/Undeformed width (m)"},
  stretch_x = {2, Name "Film/Pre-stretch along x"},
  stretch_y = {4, Name "Film/Pre-stretch along y"},
  cells_active = {8, Name "Mesh/Cells along the active strip"},
  cells_passive = {8, Name "Mesh/Cells along the passive strip"},
  cells_across = {16, Name "Mesh/Cells across"},
  order = {1, Name "Mesh/Order of the cells"}
];

bar_x = stretch_x * length_active;
end_x = bar_x + stretch_x * length_passive;
side_y = stretch_y * width;

Point(1) = {0, 0, 0};
Point(2) = {bar_x, 0, 0};
Point(3) = {end_x, 0, 0};
Point(4) = {end_x, side_y, 0};
Point(5) = {bar_x, side_y, 0};
Point(6) = {0, side_y, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};

Curve Loop(1) = {1, 7, 5, 6};
Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(2) = {2};

Transfinite Curve {1, 5} = cells_active + 1;
Transfinite Curve {2, 4} = cells_passive + 1;
Transfinite Curve {3, 6, 7} = cells_across + 1;
Transfinite Surface {1, 2};
Recombine Surface {1, 2};

Physical Surface("active") = {1};
Physical Surface("passive") = {2};
Physical Curve("frame_active_end") = {6};
Physical Curve("frame_passive_end") = {3};
Physical Curve("frame_sides") = {1, 2, 4, 5};
Physical Curve("frame_sides_active") = {1, 5};
Physical Curve("frame_sides_passive") = {2, 4};
Physical Curve("bar") = {7};

Mesh.ElementOrder = order;
