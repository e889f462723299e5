// Dielectric-elastomer minimum-energy structure: a film stretched over the
// rectangular hole of a flat frame, drawn in that flat state. The film is the
// hole, in the plane z = 0, its middle in the origin, x along the legs. Frames
// are beams along lines: end bars along the film's ends and, between corner and
// leg, "bar_*"; legs along their centre lines, free lines beside the film. With
// neither leg distance nor stand-off the legs are the film's long edges, and
// there are no lines "bar_*". Lengths in m.
DefineConstant[
  hole_length = {40e-3, Name "Hole/Length along x, pre-stretch times the film's (m)"},
  hole_width = {40e-3, Name "Hole/Width along y (m)"},
  leg_width = {5.015e-3, Name "Frame/Width of a leg (m)"},
  leg_distance = {leg_width / 2, Name "Frame/From the hole to the centre line of a leg (m)"},
  stand_off = {0, Name "Frame/Of the legs below the film (m)"},
  overhang = {0, Name "Frame/Of the legs beyond the end bars (m)"},
  cells_along = {16, Name "Mesh/Cells along the film, rounded up to an even number"},
  cells_across = {16, Name "Mesh/Cells across the film, rounded up to an even number"},
  cells_leg = {cells_along, Name "Mesh/Elements of a leg, rounded up to an even number"},
  cells_bar = {1, Name "Mesh/Elements between corner and leg"},
  cells_overhang = {1, Name "Mesh/Elements of each overhang"},
  order = {1, Name "Mesh/Order of the cells"}
];

end_x = hole_length / 2;
side_y = hole_width / 2;
half_along = Ceil(cells_along / 2);
half_across = Ceil(cells_across / 2);
has_legs = leg_distance > 0 || stand_off != 0;

// Three rows of points from front to back, each from left to right.
For row In {0 : 2}
  For column In {0 : 2}
    Point(1 + 3 * row + column) = {(column - 1) * end_x, (row - 1) * side_y, 0};
  EndFor
EndFor

// Lines 1 to 6 along x, row by row; 11 to 16 along y, column by column.
For row In {0 : 2}
  Line(1 + 2 * row) = {1 + 3 * row, 2 + 3 * row};
  Line(2 + 2 * row) = {2 + 3 * row, 3 + 3 * row};
EndFor
For column In {0 : 2}
  Line(11 + 2 * column) = {1 + column, 4 + column};
  Line(12 + 2 * column) = {4 + column, 7 + column};
EndFor
Transfinite Curve {1 : 6} = half_along + 1;
Transfinite Curve {11 : 16} = half_across + 1;

// Four quarters of the film, so that its middle lines are lines of the mesh.
For row In {0 : 1}
  For column In {0 : 1}
    quarter = 1 + 2 * row + column;
    Curve Loop(quarter) = {1 + 2 * row + column, 13 + 2 * column + row,
                           -(3 + 2 * row + column), -(11 + 2 * column + row)};
    Plane Surface(quarter) = {quarter};
  EndFor
EndFor
Transfinite Surface {1 : 4};
Recombine Surface {1 : 4};

front_legs[] = {1, 2};
back_legs[] = {5, 6};
front_middle = 2;
back_middle = 8;
If (has_legs)
  leg_y = side_y + leg_distance;
  For side In {0 : 1}
    first = 20 + 10 * side;
    y = (2 * side - 1) * leg_y;
    Point(first) = {-end_x, y, -stand_off};
    Point(first + 1) = {0, y, -stand_off};
    Point(first + 2) = {end_x, y, -stand_off};
    Line(first) = {first, first + 1};
    Line(first + 1) = {first + 1, first + 2};
    Line(first + 2) = {first, 1 + 6 * side};
    Line(first + 3) = {first + 2, 3 + 6 * side};
    Transfinite Curve {first, first + 1} = Ceil(cells_leg / 2) + 1;
    Transfinite Curve {first + 2, first + 3} = cells_bar + 1;
  EndFor
  front_legs[] = {20, 21};
  back_legs[] = {30, 31};
  front_middle = 21;
  back_middle = 31;
  Physical Curve("bar_left") = {22, 32};
  Physical Curve("bar_right") = {23, 33};
EndIf
If (overhang > 0)
  For end In {0 : 3}
    // Where the leg ends: left and right in front, left and right in the back.
    start = has_legs ? 20 + 10 * (end > 1) + 2 * (end % 2)
                     : 1 + 6 * (end > 1) + 2 * (end % 2);
    direction = 2 * (end % 2) - 1;
    ends[] = Translate {direction * overhang, 0, 0} { Duplicata { Point{start}; } };
    Line(40 + end) = {start, ends[0]};
    Transfinite Curve {40 + end} = cells_overhang + 1;
  EndFor
  Physical Curve("overhang") = {40 : 43};
EndIf

Physical Surface("film") = {1 : 4};
Physical Curve("end_left") = {11, 12};
Physical Curve("end_right") = {15, 16};
Physical Curve("side_front") = {1, 2};
Physical Curve("side_back") = {5, 6};
Physical Curve("film_middle_across") = {13, 14};
Physical Curve("leg_front") = front_legs[];
Physical Curve("leg_back") = back_legs[];

Physical Point("corner_left_front") = {1};
Physical Point("corner_right_front") = {3};
Physical Point("corner_left_back") = {7};
Physical Point("corner_right_back") = {9};
Physical Point("end_left_middle") = {4};
Physical Point("end_right_middle") = {6};
Physical Point("film_middle") = {5};
Physical Point("leg_front_middle") = {front_middle};
Physical Point("leg_back_middle") = {back_middle};

Mesh.ElementOrder = order;
