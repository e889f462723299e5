// Fields of a frame that no structure has computed.
#pragma once

#include <taut/structure/frame_fields.h>

namespace taut::io::testing
{
/// Two beam elements of three nodes on a parabola, moved along y and turned by
/// a quarter about their axes; and the frames that they belong to.
struct MadeUpBeams
{
  MadeUpBeams()
  {
    structure::RectangularSection section;
    section.width = .01;
    section.thickness = .002;
    section.young_modulus = 2e9;
    frames[1].section = structure::make_section(section);
    for (unsigned int e = 0; e < 2; ++e)
    {
      elements.push_back({1, {}});
      for (unsigned int i = 0; i < 3; ++i)
        elements[e].nodes.push_back(make_point(e + .5 * i));
    }
  }

  /// At x = s/10, the moment grows from left to right.
  static structure::FramePoint make_point(const double s)
  {
    structure::FramePoint point;
    point.mesh_position = {.1 * s, 0, .1 * s * s};
    point.displacement = {0, .01 * s, 0};
    point.axes = {{{{1, 0, 0}}, {{0, 0, 1}}, {{0, -1, 0}}}};
    point.force = {1, 2, 3};
    point.moment = {0, 5 * s, 0};
    point.strain = .001 * s;
    return point;
  }

  std::vector<structure::Frame> frames{2};
  std::vector<structure::FrameElementFields> elements;
};

} // namespace taut::io::testing
