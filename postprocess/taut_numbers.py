"""Numbers for readers: prefixes of units, round ticks, short forms. Without
Matplotlib, so that small programs start at once."""

import math
from dataclasses import dataclass

PREFIXES = {-15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k",
            6: "M", 9: "G", 12: "T"}
# Units that take a prefix in front of them.
PREFIXED = ("m", "s", "Hz", "N", "Pa", "J", "V", "A", "C", "W", "F", "Ohm",
            "V/m", "V/s", "m/s", "N m", "N/m", "A/m")


def write_unit(unit):
    """kg/m³ for kg/m^3."""
    return unit.replace("^2", "²").replace("^3", "³").replace("^4", "⁴")


@dataclass
class Scale:
    """What a number is multiplied with, and the unit it then has."""

    factor: float
    unit: str


def choose_scale(unit, values):
    """Such that the largest of the values is between 1 and 1000."""
    finite = [abs(x) for x in values if math.isfinite(x)]
    top = max(finite, default=0.0)
    if unit in ("", "1"):
        return Scale(1.0, "")
    if unit not in PREFIXED or top == 0:
        return Scale(1.0, unit)
    # 1000 m is 1 km, also when rounding makes it 999.9999.
    exponent = 3 * math.floor(math.log10(top * (1 + 1e-9)) / 3)
    exponent = min(max(exponent, min(PREFIXES)), max(PREFIXES))
    return Scale(10.0 ** -exponent, PREFIXES[exponent] + unit)


def make_label(name, unit):
    return f"{name} ({write_unit(unit)})" if unit else name


def find_step(low, high, count):
    """The round number nearest to (high - low)/count: 1, 2 or 5 times 10^n."""
    raw = (high - low) / count
    power = 10.0 ** math.floor(math.log10(raw))
    return power * min((1, 2, 5, 10), key=lambda x: abs(math.log(raw / power / x)))


def format_tick(value, step):
    """As many digits as tell neighbours apart; the very large and small by
    exponent."""
    if abs(value) < 1e-9 * step:
        return "0"
    top = math.floor(math.log10(abs(value)) + 1e-9)
    last = math.floor(math.log10(step) + 1e-9)
    if top >= 5 or top <= -5:
        text = f"{value:.{max(top - last, 0)}e}"
        mantissa, exponent = text.split("e")
        return f"{mantissa}e{int(exponent)}".replace("-", "\u2212")
    return f"{value:.{max(-last, 0)}f}".replace("-", "\u2212")


def make_ticks(low, high, count, most_letters=1000):
    """(value, text) of round numbers from low to high; fewer than `count` if
    their texts would have more letters in all."""
    ticks = place_ticks(low, high, count)
    while count > 1 and sum(len(text) for _, text in ticks) > most_letters:
        count -= 1
        ticks = place_ticks(low, high, count)
    return ticks


def place_ticks(low, high, count):
    step = find_step(low, high, count)
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [(i * step, format_tick(i * step, step))
            for i in range(first, last + 1)]


def format_number(value, digits=4):
    """Short and with a true minus; a dash for no number."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return "–"
    if isinstance(value, float) and math.isinf(value):
        return "infinite" if value > 0 else "\u2212infinite"
    if value == 0:
        return "0"
    if abs(value) >= 1e6 or abs(value) < 1e-4:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
        text = f"{mantissa} × 10^{int(exponent)}"
    elif float(value).is_integer() and abs(value) < 1e6:
        text = str(int(value))
    elif abs(value) >= 10 ** digits:
        text = f"{value:.0f}"
    else:
        text = f"{value:.{digits}g}"
    return text.replace("-", "\u2212")


def format_quantity(value, unit, digits=4):
    """With its unit and a prefix: "4.47 Hz", "32.8 mm"."""
    if value is None or not math.isfinite(value):
        return format_number(value)
    scale = choose_scale(unit, [value])
    text = format_number(value * scale.factor, digits)
    return f"{text} {write_unit(scale.unit)}" if scale.unit else text
