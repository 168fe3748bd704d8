#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws load over deflection of both variants of hinged_roof, as an SVG picture on standard output:

    sherd run hinged_roof -o roofs
    tests/app/plot_roof.py roofs > scenes/pictures/hinged_roof.svg

Dots are the limit points of Sze, Liu, Lo (2004).
"""
import pathlib
import sys

import h5py

LEFT, TOP, WIDTH, HEIGHT = 60, 20, 560, 300  # place of the axes, pixels
MOST, LOW, HIGH = 30, -0.2, 1  # deflection, mm; load factors
CURVES = [("thick", "#2166ac", "12.7 mm thick", [(11.293, 0.7421), (19.852, 0.1729)]),
          ("thin", "#b35806", "6.35 mm thick", [(12.892, 0.1953), (15.778, -0.1288)])]


def across(deflection):
    return LEFT + WIDTH * deflection / MOST


def up(load):
    return TOP + HEIGHT * (HIGH - load) / (HIGH - LOW)


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{words}</text>'


def axes():
    for fifths in range(-1, 6):
        colour = "#444" if fifths == 0 else "#ddd"
        yield (f'<line x1="{LEFT}" x2="{LEFT + WIDTH}" y1="{up(fifths / 5):.1f}" y2="{up(fifths / 5):.1f}" '
               f'stroke="{colour}"/>')
        yield text(LEFT - 8, up(fifths / 5) + 4, f"{fifths / 5:.1f}", "end")
    for deflection in range(0, MOST + 1, 5):
        yield text(across(deflection), TOP + HEIGHT + 20, str(deflection))
    yield text(LEFT + WIDTH / 2, TOP + HEIGHT + 42, "deflection of the middle, mm")
    yield text(0, 0, "load over 3000 N", more=f' transform="translate(18 {TOP + HEIGHT / 2}) rotate(-90)"')


def curves(folder):
    for row, (variant, colour, words, limits) in enumerate(CURVES):
        with h5py.File(folder / f"hinged_roof-{variant}.h5") as run:
            points = zip(-run["gauges/middle/displacement"][:, 2], run["steps/load"])
            line = " ".join(f"{across(w):.1f},{up(load):.1f}" for w, load in [(0, 0), *points] if w < MOST)
        yield f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>'
        for deflection, load in limits:
            yield f'<circle cx="{across(deflection):.1f}" cy="{up(load):.1f}" r="4.5" fill="{colour}"/>'
        yield text(LEFT + 14, TOP + 22 + 20 * row, words, "start", f' fill="{colour}"')


def main():
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {LEFT + WIDTH + 20} {TOP + HEIGHT + 60}" '
          f'font-family="Helvetica, Arial, sans-serif" font-size="13">')
    print('<rect width="100%" height="100%" fill="white"/>')
    print("\n".join([*axes(), *curves(pathlib.Path(sys.argv[1]))]))
    print("</svg>")


if __name__ == "__main__":
    main()
