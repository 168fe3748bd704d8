#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the table that TheoryStrips prints, read from standard input, as an SVG picture on standard output:

    tests/run -R TheoryStrips -V | tests/fracture/plot_strips.py > scenes/pictures/strips.svg
"""
import re
import sys

LEFT, TOP, WIDTH, HEIGHT = 60, 20, 560, 320  # place of the axes, pixels
NUMBER = r"\s+([0-9.]+)"
ROW = re.compile("strip:" + 7 * NUMBER)  # angle; measured, least, most; 1/S11, D11, eq. 8
THEORY = [(4, "#1b7837", "", "plate theory, narrow free strip: 1/S11"),
          (5, "#762a83", "7 4", "plate theory, forced into a cylinder: D11"),
          (6, "#b35806", "2 3", "the paper's eq. 8")]
MEASURED = "#2166ac"


def across(degrees):
    return LEFT + WIDTH * degrees / 90


def up(rigidity):
    return TOP + HEIGHT * (1 - rigidity / 1.05)


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{words}</text>'


def line(x0, y0, x1, y1, colour, dashes="", width=1):
    return (f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" stroke="{colour}" '
            f'stroke-width="{width}" stroke-dasharray="{dashes or "none"}"/>')


def axes():
    for tenths in range(0, 11, 2):
        yield line(LEFT, up(tenths / 10), LEFT + WIDTH, up(tenths / 10), "#ddd")
        yield text(LEFT - 8, up(tenths / 10) + 4, f"{tenths / 10:.1f}", "end")
    for degrees in range(0, 91, 15):
        yield line(across(degrees), up(0), across(degrees), up(0) + 5, "#444")
        yield text(across(degrees), up(0) + 20, f"{degrees}°")
    yield line(LEFT, up(0), LEFT + WIDTH, up(0), "#444")
    yield text(LEFT + WIDTH / 2, up(0) + 42, "angle of the strip to the first axis")
    yield text(0, 0, "rigidity over that along the first axis",
               more=f' transform="translate(18 {TOP + HEIGHT / 2}) rotate(-90)"')


def curve(rows, column, colour, dashes):
    points = " ".join(f"{across(row[0]):.1f},{up(row[column]):.1f}" for row in rows)
    return (f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2" '
            f'stroke-dasharray="{dashes or "none"}"/>')


def measured(rows):
    for row in rows:
        yield line(across(row[0]), up(row[2]), across(row[0]), up(row[3]), MEASURED, width=2)
        yield f'<circle cx="{across(row[0]):.1f}" cy="{up(row[1]):.1f}" r="4.5" fill="{MEASURED}"/>'


def legend():
    x, y = LEFT + 0.44 * WIDTH, TOP + 14
    yield f'<rect x="{x - 10:.1f}" y="{y - 14:.1f}" width="320" height="88" fill="white"/>'
    yield f'<circle cx="{x + 14:.1f}" cy="{y:.1f}" r="4.5" fill="{MEASURED}"/>'
    yield text(x + 36, y + 4, "measured: mean and range of 4 meshes", "start")
    for _, colour, dashes, words in THEORY:
        y += 20
        yield line(x, y, x + 28, y, colour, dashes, 2)
        yield text(x + 36, y + 4, words, "start")


def main():
    rows = [[float(number) for number in row.groups()] for row in map(ROW.search, sys.stdin) if row]
    if len(rows) != 7:
        sys.exit(f"plot_strips.py: {len(rows)} rows of a strip in the input, not 7; give it what TheoryStrips prints")
    print(f'<svg xmlns="http://www.w3.org/2000/svg" width="{LEFT + WIDTH + 20}" height="{TOP + HEIGHT + 55}" '
          'font-family="sans-serif" font-size="13" fill="#222">')
    print("<!-- SPDX-License-Identifier: GPL-3.0-or-later; drawn by tests/fracture/plot_strips.py -->")
    print('<rect width="100%" height="100%" fill="white"/>')
    print(*axes(), *(curve(rows, *theory[:3]) for theory in THEORY), *measured(rows), *legend(), sep="\n")
    print("</svg>")


if __name__ == "__main__":
    main()
