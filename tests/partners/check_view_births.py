# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays the page of a recording in which faces are split, in Chromium: between frames the pieces, which move rigidly
and are flat at rest, must move in straight lines, and each frame must have all faces.

usage: check_view_births.py PAGE RECORDING.h5"""
import pathlib
import sys

import h5py
import numpy as np

from check_view import Page, browser
from rigid_pieces import between

STATE = """
    const { faces, fragments, place } = playback.at(arguments[0]);
    return [Array.from(faces), Array.from(fragments), Array.from(place)];"""


def main(file, recording):
    driver = browser()
    try:
        page = Page(driver, pathlib.Path(file))
        def state(position):
            faces, fragments, place = page.driver.execute_script(STATE, position)
            return np.reshape(faces, (-1, 3)), np.array(fragments), np.reshape(place, (-1, 3))
        with h5py.File(recording) as run:
            frames = [run["frames"][name] for name in sorted(run["frames"])]
            shift = state(0)[2][0] - frames[0]["vertex/position"][0]
            extent = np.ptp(np.concatenate([frame["vertex/position"][:] for frame in frames]), axis=0).max()
            for number in [*range(len(frames)), 0]:  # backwards the topology is rebuilt
                frame = frames[number]
                faces, fragments, place = state(number)
                assert np.array_equal(faces, frame["face/vertices"][:]), number
                assert np.array_equal(fragments, frame["face/fragment"][:]), number
                assert np.allclose(place, frame["vertex/position"][:] + shift, rtol=0, atol=3e-5 * extent), number
            for number in range(len(frames) - 1):
                later = frames[number + 1]
                faces, fragments, place = state(number + 0.25)
                assert np.array_equal(faces, later["face/vertices"][:]), number
                known = np.isin(later["face/fragment"][:], frames[number]["face/fragment"][:])
                assert np.array_equal(fragments, np.where(known, later["face/fragment"][:], 0)), (number, fragments)
                off = np.abs(place - between(run, number, 0.25) - shift).max()
                assert off < 5e-5 * extent, (number, off)
            page.driver.execute_script("showMoment(arguments[0])", len(frames) - 1.5)
            assert page.shown("faces") == len(frames[-1]["face/vertices"])
            assert page.shown("triangles") > 2 * page.shown("faces"), "no thickness"
        errors = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
        assert not errors, errors
    finally:
        driver.quit()
    print(f"the page shows all {len(frames)} frames and what is between")


main(*sys.argv[1:])
