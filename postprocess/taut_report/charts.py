"""Charts as small inline SVG: colours are CSS variables and text takes the
colour of the page, so that they are legible dark and light."""

import math
from dataclasses import dataclass, field

import taut_numbers as numbers

from .markup import Markup, raise_exponent, tag

WIDTH, HEIGHT = 330, 214
LEFT, RIGHT, TOP, BOTTOM = 50, 12, 10, 42
# As many columns of pixels; each keeps its extremes.
BUCKETS = 280
# The first two differ in brightness, too.
DASHES = [None, None, "5 2", "8 2 2 2", "2 2", "12 3", "1 3"]
N_COLOURS = len(DASHES)
NOTHING = 1e-9


@dataclass
class Axis:
    """Label, unit of the values, whether the scale is logarithmic."""

    label: str
    unit: str
    values: list
    is_logarithmic: bool = False


@dataclass
class Series:
    """`ways`: how each point is reached from the one before, "-", "--" or ":";
    `marks`: draw the points; `line`: join them."""

    name: str
    values: list
    ways: list = None
    marks: bool = False
    line: bool = True


@dataclass
class Mark:
    """Something that happened at x."""

    x: float
    name: str


@dataclass
class Chart:
    title: str
    x: Axis
    unit: str
    series: list
    marks: list = field(default_factory=list)
    note: str = ""


class Map:
    """From values to places in the drawing."""

    def __init__(self, low, high, start, end, is_logarithmic=False):
        self.is_logarithmic = is_logarithmic
        self.low, self.high = self.turn(low), self.turn(high)
        self.start, self.end = start, end

    def turn(self, value):
        return math.log10(value) if self.is_logarithmic else value

    def __call__(self, value):
        share = (self.turn(value) - self.low) / (self.high - self.low)
        return self.start + share * (self.end - self.start)


def find_finite(values):
    return [v for v in values if math.isfinite(v)]


def find_range(values, margin):
    finite = find_finite(values)
    if not finite:
        return 0.0, 1.0
    low, high = min(finite), max(finite)
    if high - low <= 1e-12 * max(abs(low), abs(high)):
        half = 0.5 * abs(low) or 0.5
        return low - half, high + half
    return low - margin * (high - low), high + margin * (high - low)


def thin(indices, values):
    """Of many points, the first, lowest, highest and last of each bucket."""
    if len(indices) <= 4 * BUCKETS:
        return indices
    kept = []
    size = len(indices) / BUCKETS
    for bucket in range(BUCKETS):
        part = indices[round(bucket * size):round((bucket + 1) * size)]
        low = min(part, key=lambda i: values[i])
        high = max(part, key=lambda i: values[i])
        kept += sorted({part[0], low, high, part[-1]})
    return kept


def split(x, y, ways):
    """(way, indices) of the pieces without gaps and of one style."""
    pieces, current, way = [], [], None
    for i, (a, b) in enumerate(zip(x, y)):
        if not (math.isfinite(a) and math.isfinite(b)):
            pieces.append((way, current))
            current = []
            continue
        here = ways[i] if ways else "-"
        if current and here != way:
            pieces.append((way, current))
            current = current[-1:]
        way = here
        current.append(i)
    pieces.append((way, current))
    return [(style, piece) for style, piece in pieces if piece]


def draw_path(points):
    text = "".join(f"{'L' if i else 'M'}{a:.1f} {b:.1f}"
                   for i, (a, b) in enumerate(points))
    return text.replace(".0 ", " ").replace(".0L", "L")


def draw_series(x, series, place, to_x, to_y):
    drawn = []
    colour = place % N_COLOURS
    style = f"stroke:var(--series-{colour})"
    if series.line:
        for way, piece in split(x, series.values, series.ways):
            dash = {"--": "5 3", ":": "1 3"}.get(way, DASHES[colour]
                                                 if not series.ways else None)
            points = [(to_x(x[i]), to_y(series.values[i]))
                      for i in thin(piece, series.values)]
            drawn.append(tag("path", d=draw_path(points), style=style,
                             class_="curve", stroke_dasharray=dash))
    if series.marks:
        fill = f"fill:var(--series-{colour})"
        drawn += [tag("circle", cx=f"{to_x(a):.1f}", cy=f"{to_y(b):.1f}", r=2.6,
                      style=fill)
                  for a, b in zip(x, series.values)
                  if math.isfinite(a) and math.isfinite(b)]
    return drawn


def make_logarithmic_ticks(low, high):
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(
        math.log10(high) + 1e-9)
    step = max(1, math.ceil((last - first) / 5))
    ticks = [(10.0 ** n, numbers.format_number(10.0 ** n))
             for n in range(first, last + 1, step)]
    if len(ticks) >= 2:
        return ticks
    return [(m * 10.0 ** n, numbers.format_number(m * 10.0 ** n))
            for n in range(first - 1, last + 1) for m in (1, 2, 5)
            if low <= m * 10.0 ** n <= high]


def draw_x_axis(low, high, to_x, is_logarithmic):
    bottom = HEIGHT - BOTTOM
    ticks = (make_logarithmic_ticks(low, high) if is_logarithmic
             else numbers.make_ticks(low, high, 5, most_letters=30))
    drawn = []
    for value, text in ticks:
        at = f"{to_x(value):.1f}"
        drawn.append(tag("line", x1=at, x2=at, y1=bottom, y2=bottom + 4,
                         class_="axis"))
        drawn.append(tag("text", text, x=at, y=bottom + 16,
                         text_anchor="middle"))
    return drawn


def draw_y_axis(low, high, to_y):
    drawn = []
    for value, text in numbers.make_ticks(low, high, 5):
        at = to_y(value)
        kind = "zero" if text == "0" else "grid"
        drawn.append(tag("line", x1=LEFT, x2=WIDTH - RIGHT, y1=f"{at:.1f}",
                         y2=f"{at:.1f}", class_=kind))
        drawn.append(tag("text", text, x=LEFT - 6, y=f"{at + 3.6:.1f}",
                         text_anchor="end"))
    return drawn


def draw_marks(marks, to_x, low, high):
    drawn = []
    for mark in marks:
        if low <= mark.x <= high:
            at = f"{to_x(mark.x):.1f}"
            drawn.append(tag("line", tag("title", mark.name), x1=at, x2=at,
                             y1=TOP, y2=HEIGHT - BOTTOM, class_="mark"))
    return drawn


def describe_range(chart):
    values = find_finite([v for s in chart.series for v in s.values])
    if not values:
        return "no values"
    scale = numbers.choose_scale(chart.unit, values)
    # What is rounding beside the rest is nothing.
    least = NOTHING * max(map(abs, values))
    low, high = (numbers.format_number(scale.factor * v if abs(v) > least
                                       else 0)
                 for v in (min(values), max(values)))
    unit = f" {scale.unit}" if scale.unit else ""
    if low == high:
        return f"{low}{unit} throughout"
    return f"{low} to {high}{unit}"


def make_legend(series):
    if len(series) < 2:
        return None
    items = []
    for place, one in enumerate(series):
        colour = place % N_COLOURS
        style = f"stroke:var(--series-{colour})"
        sample = tag("svg", tag("path", d="M0 5H26", style=style,
                                class_="curve",
                                stroke_dasharray=DASHES[colour]),
                     viewBox="0 0 26 10", width=26, height=10,
                     aria_hidden="true")
        items.append(tag("li", sample, " ", one.name))
    return tag("ul", items, class_="legend")


def scale_chart(chart):
    """x and the series in the units of the axes, and their labels."""
    everything = [v for s in chart.series for v in s.values]
    x_scale = numbers.choose_scale(chart.x.unit, chart.x.values)
    y_scale = numbers.choose_scale(chart.unit, everything)
    x = [x_scale.factor * v for v in chart.x.values]
    series = [Series(s.name, [y_scale.factor * v for v in s.values], s.ways,
                     s.marks, s.line) for s in chart.series]
    marks = [Mark(x_scale.factor * m.x, m.name) for m in chart.marks]
    return x, series, marks, numbers.make_label(
        chart.x.label, x_scale.unit), y_scale.unit


def draw(chart):
    """The <svg> of a chart."""
    x, series, marks, x_label, _ = scale_chart(chart)
    is_logarithmic = chart.x.is_logarithmic and min(find_finite(x),
                                                    default=0) > 0
    # Points at the ends stay within the frame.
    has_marks = any(one.marks for one in series) and not is_logarithmic
    low_x, high_x = find_range(x, 0.02 if has_marks else 0.0)
    low_y, high_y = find_range([v for s in series for v in s.values], 0.05)
    to_x = Map(low_x, high_x, LEFT, WIDTH - RIGHT, is_logarithmic)
    to_y = Map(low_y, high_y, HEIGHT - BOTTOM, TOP)
    bottom = HEIGHT - BOTTOM
    frame = tag("line", x1=LEFT, x2=WIDTH - RIGHT, y1=bottom, y2=bottom,
                class_="axis")
    label = tag("text", x_label, x=(LEFT + WIDTH - RIGHT) / 2, y=HEIGHT - 6,
                text_anchor="middle", class_="label")
    curves = [draw_series(x, one, place, to_x, to_y)
              for place, one in enumerate(series)]
    return tag("svg", draw_y_axis(low_y, high_y, to_y), frame,
               draw_x_axis(low_x, high_x, to_x, is_logarithmic),
               draw_marks(marks, to_x, low_x, high_x), curves, label,
               viewBox=f"0 0 {WIDTH} {HEIGHT}", role="img",
               aria_label=f"{chart.title} over {chart.x.label}: "
                          f"{describe_range(chart)}")


def make_figure(chart):
    """The chart with title, range and legend."""
    _, _, _, _, unit = scale_chart(chart)
    title = numbers.make_label(chart.title[:1].upper() + chart.title[1:], unit)
    words = [tag("strong", title), " ",
             tag("span", chart.note or raise_exponent(describe_range(chart)),
                 class_="range")]
    return tag("figure", tag("figcaption", words), make_legend(chart.series),
               draw(chart), class_="chart")


def make_gallery(charts):
    figures = [make_figure(chart) for chart in charts]
    return tag("div", figures, class_="charts") if figures else Markup("")
