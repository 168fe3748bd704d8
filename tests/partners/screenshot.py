# SPDX-License-Identifier: GPL-3.0-or-later
"""with_display pvpython screenshot.py RUN.xdmf OUT.png [--frame -1] [--size 1200x800] [--direction 1,-2,1.2]

Draws a frame of a recording, its fragments in different colours and its cracks as lines."""

import argparse
import os

from paraview.simple import (
    ColorBy,
    CreateRenderView,
    ExtractBlock,
    GetColorTransferFunction,
    ResetCamera,
    SaveScreenshot,
    Show,
    Threshold,
    XDMFReader,
)

# Neighbouring colours differ strongly, because neighbouring numbers of fragments have no meaning.
PALETTE = ["#4e79a7", "#f28e2b", "#76b7b2", "#e15759", "#59a14f", "#edc948", "#b07aa1", "#9c755f", "#ff9da7", "#bab0ac"]


def options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("index", help="the .xdmf of a recording")
    parser.add_argument("picture", help="the .png to write")
    parser.add_argument("--frame", type=int, default=-1, help="number of the frame, from the end if negative")
    parser.add_argument("--size", default="1200x800", help="in pixels")
    parser.add_argument("--direction", default="1,-2,1.2", help="from the sheet to the camera")
    return parser.parse_args()


def colour(number):
    code = PALETTE[number % len(PALETTE)].lstrip("#")
    return [int(code[i : i + 2], 16) / 255 for i in (0, 2, 4)]


def colour_by_fragment(display, count):
    display.ColorArrayName = ["CELLS", "fragment"]
    table = GetColorTransferFunction("fragment")
    table.InterpretValuesAsCategories = 1
    table.Annotations = [text for i in range(count) for text in (str(i), str(i))]
    table.IndexedColors = [part for i in range(count) for part in colour(i)]
    display.LookupTable = table


def main():
    wanted = options()
    reader = XDMFReader(FileNames=[wanted.index])
    reader.UpdatePipelineInformation()
    time = list(reader.TimestepValues)[wanted.frame]
    view = CreateRenderView()
    view.ViewTime = time
    view.ViewSize = [int(length) for length in wanted.size.split("x")]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0

    surface = ExtractBlock(Input=reader, Selectors=["/Root/surface"])
    surface.UpdatePipeline(time)
    fragments = int(surface.CellData["fragment"].GetRange()[1]) + 1
    colour_by_fragment(Show(surface, view), fragments)
    cracks = Threshold(Input=ExtractBlock(Input=reader, Selectors=["/Root/edges"]), Scalars=["CELLS", "state"])
    cracks.LowerThreshold, cracks.UpperThreshold = 1, 2
    lines = Show(cracks, view)
    ColorBy(lines, None)
    lines.AmbientColor = lines.DiffuseColor = [0.1, 0.1, 0.1]
    lines.LineWidth = 1.5

    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = [float(part) for part in wanted.direction.split(",")]
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)
    SaveScreenshot(wanted.picture, view)
    if os.path.getsize(wanted.picture) < 2000:
        raise SystemExit(f"{wanted.picture}: an empty picture")
    print(f"{wanted.picture}: {fragments} fragments at {time:.6g} s")


main()
