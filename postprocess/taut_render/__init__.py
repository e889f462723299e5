"""The parts of `taut render`: what there is to draw, the drawing by ParaView,
labels, animations."""
