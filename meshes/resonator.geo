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
  bar_gap = {0, Name "Bar/Distance of its ends from the frame (m)"},
  cells_gap = {2, Name "Mesh/Cells across each distance"},
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
If (bar_gap > 0)
  Point(7) = {bar_x, bar_gap, 0};
  Point(8) = {bar_x, side_y - bar_gap, 0};
  Line(7) = {7, 8};
  Line(8) = {2, 7};
  Line(9) = {8, 5};
  between[] = {8, 7, 9};
  Transfinite Curve {8, 9} = cells_gap + 1;
  Transfinite Curve {7} = cells_across - 2 * cells_gap + 1;
Else
  Line(7) = {2, 5};
  between[] = {7};
  Transfinite Curve {7} = cells_across + 1;
EndIf

Curve Loop(1) = {1, between[], 5, 6};
Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -between[]};
Plane Surface(2) = {2};

Transfinite Curve {1, 5} = cells_active + 1;
Transfinite Curve {2, 4} = cells_passive + 1;
Transfinite Curve {3, 6} = cells_across + 1;
Transfinite Surface {1} = {1, 2, 5, 6};
Transfinite Surface {2} = {2, 3, 4, 5};
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
