"""The parts of `taut report`: reading a folder, charts, sections, the page."""
