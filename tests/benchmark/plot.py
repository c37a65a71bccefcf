"""Lines over logarithmic axes as SVG, panels side by side."""

import math

WIDTH, HEIGHT = 360, 280
LEFT, RIGHT, TOP, BOTTOM = 88, 58, 34, 46
INK, GRID, REFERENCE = "#333", "#e3e3e3", "#777"
COLORS = ("#0072b2", "#d55e00", "#009e73")  # told apart by every kind of eye


def text(x, y, content, anchor="middle", color=INK, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}"{more}>{content}</text>'


class Panel:
    """One diagram: `lines` is a list of (label, [(x, y)]), `reference` such a pair, drawn dashed."""

    def __init__(self, title, lines, reference):
        self.title = title
        self.lines = lines
        self.reference = reference

    def points(self):
        return [p for _, line in [*self.lines, self.reference] for p in line]

    def draw(self, offset, x_label, y_label):
        xs = sorted({x for x, _ in self.points()})
        low = math.floor(math.log10(min(y for _, y in self.points())))
        high = math.ceil(math.log10(max(y for _, y in self.points())))
        width, height = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
        span = math.log(xs[-1] / xs[0]) or 1

        def place(x, y):
            return (offset + LEFT + width * math.log(x / xs[0]) / span,
                    TOP + height * (high - math.log10(y)) / (high - low))

        out = [text(offset + LEFT + width / 2, 18, self.title, more=' font-weight="bold"')]
        for exponent in range(low, high + 1):
            left, y = place(xs[0], 10**exponent)
            out.append(f'<path d="M{left:.1f} {y:.1f}h{width}" stroke="{GRID}"/>')
            out.append(text(left - 6, y + 4, f"{10**exponent:,}" if exponent >= 0 else f"{10**exponent:g}", "end"))
        for x in sorted({x for _, line in self.lines for x, _ in line}):
            at, bottom = place(x, 10**low)
            out.append(f'<path d="M{at:.1f} {bottom:.1f}v{-height}" stroke="{GRID}"/>')
            out.append(text(at, bottom + 16, f"{x:g}"))
        out.append(text(offset + LEFT + width / 2, HEIGHT - 10, x_label))
        middle = TOP + height / 2
        out.append(text(offset + 14, middle, y_label, more=f' transform="rotate(-90 {offset + 14} {middle})"'))
        out += self.draw_lines(place)
        return out

    def draw_lines(self, place):
        out, labels = [], []
        styled = [(line, color, 'stroke-width="2"') for line, color in zip(self.lines, COLORS)]
        styled.append((self.reference, REFERENCE, 'stroke-dasharray="5 4"'))
        for (label, line), color, style in styled:
            path = "L".join("{:.1f} {:.1f}".format(*place(x, y)) for x, y in line)
            out.append(f'<path d="M{path}" fill="none" stroke="{color}" {style}/>')
            labels.append((*place(*line[-1]), label, color))
        # Labels at the ends of their lines, moved down where they would overlap.
        lowest = -math.inf
        for x, y, label, color in sorted(labels, key=lambda l: l[1]):
            lowest = max(y + 4, lowest + 13)
            out.append(text(x + 6, lowest, label, "start", color))
        return out


def write_svg(path, panels, x_label, y_label):
    width = WIDTH * len(panels)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {HEIGHT}" width="{width}" height="{HEIGHT}" '
           'font-family="sans-serif" font-size="12">', f'<rect width="{width}" height="{HEIGHT}" fill="white"/>']
    for i, panel in enumerate(panels):
        out += panel.draw(i * WIDTH, x_label, y_label)
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join([*out, "</svg>", ""]))
