// Membrane resonator: two strips of one film side by side in a rigid frame, the
// active one with electrodes, and a rigid bar on the line between them. Drawn in
// the framed shape, that is after the pre-stretch: lengths of the undeformed
// film times the stretch. x runs along the motion of the bar. With a margin the
// electrode ends before the frame, on all three sides: "active" is what it covers,
// "margin_active" the bare rim of the same strip. Lengths in m.
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
  margin = {0, Name "Electrode/Distance from the frame, in the framed shape (m)"},
  cells_margin = {2, Name "Mesh/Cells across the margin"},
  order = {1, Name "Mesh/Order of the cells"}
];

bar_x = stretch_x * length_active;
end_x = bar_x + stretch_x * length_passive;
side_y = stretch_y * width;

If (margin > 0)
  // A grid: columns of the rim, the electrode and the passive strip; rows by the
  // edges of the electrode and the ends of the bar. Every line between the rows
  // runs from frame to frame, so the cells stay rectangles.
  x[] = {0, margin, bar_x, end_x};
  cells_x[] = {cells_margin, cells_active, cells_passive};
  If (bar_gap == 0 || bar_gap == margin)
    y[] = {0, margin, side_y - margin, side_y};
  Else
    outer = bar_gap < margin ? bar_gap : margin;
    inner = bar_gap < margin ? margin : bar_gap;
    y[] = {0, outer, inner, side_y - inner, side_y - outer, side_y};
  EndIf
  rows = #y[] - 1;
  For row In {0 : rows}
    For column In {0 : 3}
      Point(1 + 4 * row + column) = {x[column], y[row], 0};
    EndFor
  EndFor
  // Lines 101 on along x, 201 on along y, row by row.
  For row In {0 : rows}
    For column In {0 : 2}
      Line(101 + 3 * row + column) = {1 + 4 * row + column, 2 + 4 * row + column};
      Transfinite Curve {101 + 3 * row + column} = cells_x[column] + 1;
    EndFor
  EndFor
  active[] = {};
  rim[] = {};
  passive[] = {};
  bar[] = {};
  active_end[] = {};
  passive_end[] = {};
  For row In {0 : rows - 1}
    height = y[row + 1] - y[row];
    share = Ceil(cells_across * height / side_y - 1e-9);
    cells = y[row + 1] <= margin || y[row] >= side_y - margin ? cells_margin : 1;
    cells = share > cells ? share : cells;
    For column In {0 : 3}
      Line(201 + 4 * row + column) = {1 + 4 * row + column, 5 + 4 * row + column};
      Transfinite Curve {201 + 4 * row + column} = cells + 1;
    EndFor
    For column In {0 : 2}
      surface = 1 + 3 * row + column;
      Curve Loop(surface) = {101 + 3 * row + column, 202 + 4 * row + column,
                             -(104 + 3 * row + column), -(201 + 4 * row + column)};
      Plane Surface(surface) = {surface};
    EndFor
    covered = y[row] >= margin && y[row + 1] <= side_y - margin;
    rim[] += {1 + 3 * row};
    If (covered)
      active[] += {2 + 3 * row};
    Else
      rim[] += {2 + 3 * row};
    EndIf
    passive[] += {3 + 3 * row};
    If (y[row] >= bar_gap && y[row + 1] <= side_y - bar_gap)
      bar[] += {203 + 4 * row};
    EndIf
    active_end[] += {201 + 4 * row};
    passive_end[] += {204 + 4 * row};
  EndFor
  sides_active[] = {101, 102, 101 + 3 * rows, 102 + 3 * rows};
  sides_passive[] = {103, 103 + 3 * rows};
  Transfinite Surface {1 : 3 * rows};
  Recombine Surface {1 : 3 * rows};
  Physical Surface("margin_active") = rim[];
Else
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
  active[] = {1};
  passive[] = {2};
  bar[] = {7};
  active_end[] = {6};
  passive_end[] = {3};
  sides_active[] = {1, 5};
  sides_passive[] = {2, 4};
EndIf

Physical Surface("active") = active[];
Physical Surface("passive") = passive[];
Physical Curve("frame_active_end") = active_end[];
Physical Curve("frame_passive_end") = passive_end[];
Physical Curve("frame_sides") = {sides_active[], sides_passive[]};
Physical Curve("frame_sides_active") = sides_active[];
Physical Curve("frame_sides_passive") = sides_passive[];
Physical Curve("bar") = bar[];
// What a frame clamps: the sides as well, unless the bar reaches them and they have
// to follow it.
fixed[] = {active_end[], passive_end[]};
If (bar_gap > 0)
  fixed[] += {sides_active[], sides_passive[]};
EndIf
Physical Curve("frame_fixed") = fixed[];

Mesh.ElementOrder = order;
