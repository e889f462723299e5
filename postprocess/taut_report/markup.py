"""HTML from Python: every text is escaped, nothing else is done."""

from html import escape

from taut_numbers import format_number, format_quantity

EMPTY = {"img", "br", "meta", "source", "line", "path", "circle", "rect",
         "polyline"}


class Markup(str):
    """Text that is HTML already."""


def to_markup(child):
    """Lists are joined, None is nothing, text is escaped."""
    if child is None:
        return ""
    if isinstance(child, Markup):
        return child
    if isinstance(child, (list, tuple)):
        return "".join(to_markup(item) for item in child)
    return escape(str(child))


def tag(name, /, *children, **attributes):
    """<name attributes>children</name>; class_ is class, stroke_width is
    stroke-width, and an attribute of None is left out."""
    text = f"<{name}"
    for key, value in attributes.items():
        if value is None or value is False:
            continue
        key = key.rstrip("_").replace("_", "-")
        text += f" {key}" if value is True else f' {key}="{escape(str(value))}"'
    if name in EMPTY:
        return Markup(text + ">" if name not in ("line", "path", "circle",
                                                 "rect", "polyline")
                      else text + "/>")
    return Markup(f"{text}>{to_markup(children)}</{name}>")


def raise_exponent(text):
    """10^-5 with a raised exponent, in text or in "4 × 10^-5 J"."""
    words = []
    for word in text.split(" "):
        base, caret, exponent = word.partition("^")
        words.append(tag("span", base, tag("sup", exponent))
                     if caret and base == "10" else to_markup(word))
    return Markup(" ".join(words))


def number(value, digits=4):
    return raise_exponent(format_number(value, digits))


def quantity(value, unit, digits=4):
    return raise_exponent(format_quantity(value, unit, digits))


def section(identifier, title, *children):
    """A part of the page; none if it holds nothing."""
    children = [child for child in children if child]
    if not children:
        return None
    return tag("section", tag("h2", title), children, id=identifier)


def table(caption, head, rows, kinds=None, stacks=False):
    """`kinds`: "n" for the columns of numbers, "t" for text, "w" for words that
    stay in one line, one letter each. Wide tables scroll inside, or on a phone
    their cells are stacked."""
    kinds = kinds or "t" * len(head)
    classes = [{"n": "number", "t": None, "w": "words"}[kind] for kind in kinds]
    body = []
    for row in rows:
        cells = [tag("th", row[0], scope="row", class_=classes[0])]
        cells += [tag("td", cell, class_=kind)
                  for cell, kind in zip(row[1:], classes[1:])]
        body.append(tag("tr", cells))
    heads = [tag("th", cell, scope="col", class_=kind)
             for cell, kind in zip(head, classes)]
    return tag("div", tag("table", tag("caption", caption),
                          tag("thead", tag("tr", heads)), tag("tbody", body)),
               class_="scroll stack" if stacks else "scroll", tabindex="0",
               role="region", aria_label=caption)


def facts(pairs):
    """A short list of names and values."""
    return tag("dl", [tag("div", tag("dt", name), tag("dd", value))
                      for name, value in pairs], class_="facts")
