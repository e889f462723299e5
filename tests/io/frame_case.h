// Cases with frames, for tests.
#pragma once

namespace taut::io::testing
{
/// One of every section; the film is attached to the legs at its corners.
inline const char* const frame_case = R"(subsection Mesh
  set File = demes.geo
end
subsection Material rubber
  set Density = 960
  subsection Spring ground
    set Law = neo-Hookean
    set Shear modulus = 50e3
  end
end
subsection Film film
  set Surfaces = film
  set Material = rubber
  set Thickness = 0.5e-3
end
subsection Frame legs
  set Lines = leg_front, leg_back
  set Width = 5e-3
  set Thickness = 0.8e-3
  set Young modulus = 2e9
  set Density = 1050
  set Normal = 0, 0, 2
  set Attachment = at
  set Attached at = corner_left, bar_right
  set Offset = half thickness
  set Temperature = steps(0: 299, 0.5: 340)
  set Modulus law = polynomial(299, 273, 361; -0.006)
  set Mass damping = 3
  set Stiffness damping = 1e-4
end
subsection Frame ends
  set Lines = end_left, end_right
  set Section = stiffnesses
  set Axial stiffness = 1e4
  set Shear stiffness = 2e3, 3e3
  set Torsional stiffness = 4e-3
  set Bending stiffness = 5e-3, 6e-3
  set Mass per length = 0.007
  set Rotary inertia per length = 1e-8, 2e-8, 3e-8
  set Depth = 1e-3
end
subsection Hinge corner
  set Points = corner_left
end
subsection Rigid body bar
  set Groups = bar_left
  set Centre = 0, 0, 0.01
  set Mass = 0.02
  set Rotary inertia = 1e-6, 2e-6, 3e-6
end
subsection Rigid body other
  set Groups = bar_right
end
subsection Point mass tip
  set Points = corner_right
  set Mass = 0.5e-3
  set Rotary inertia = 1e-5, 0, 0
end
subsection Point load pull
  set Points = corner_right
  set Force direction = 0, 0, 1
  set Force = 2
  set Moment direction = 0, 1, 0
  set Moment = 0.25
  set Follower = true
end
subsection Support middle
  set Groups = leg_middle
  set Acts on = frame
  set Held = x, z
  set Held rotations = y
end
subsection Probe turn
  set Quantity = rotation
  set Of = corner_left
  set Component = y
end
subsection Probe opening
  set Quantity = half angle
  set Of = end_left, end_right
  set Component = y
end
subsection Probe chord
  set Quantity = distance
  set Of = end_left, end_right
end
subsection Probe moment
  set Quantity = frame moment
  set Of = legs
  set At = leg_middle
  set Component = second
end
subsection Probe force
  set Quantity = frame force
  set Of = legs
  set Point = 0, 0.02, 0
end
subsection Probe strain
  set Quantity = frame strain
  set Of = legs
end
subsection Probe heat
  set Quantity = temperature
  set Of = legs
end
subsection Procedure
  set Start shape = rest
  subsection Rest shape
    set Direction = 0, 0, -1
    set Perturbation = 0.02
    set First stiffness = 30
    set Steps = 12
    set Both branches = true
  end
end
)";

/// A frame on its own.
inline const char* const free_frame = R"(subsection Mesh
  set File = beam.geo
end
subsection Frame beam
  set Lines = beam
  set Width = 5e-3
  set Thickness = 1e-3
  set Young modulus = 2e9
  set Density = 0
end
subsection Procedure
  set Start shape = meshed
end
)";

} // namespace taut::io::testing
