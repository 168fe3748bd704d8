# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the player for Blender without Blender, for a recording in which vertices move within a flat sheet at rest:
between frames the sheet must not move either, and faces must belong to pieces of the earlier frame.

usage: check_player_moves.py BLENDER RECORDING.h5, BLENDER: app/blender"""
import sys

import h5py
import numpy as np

from check_player import player


def main(folder, recording):
    module = player(folder).playback
    with h5py.File(recording) as file:
        states = [module.recorded(file["frames"][name]) for name in sorted(file["frames"])]
    assert any(state["rest"]["mixed"] for state in states), "no face has parts of others in this recording"
    for number, (earlier, later) in enumerate(zip(states, states[1:])):
        shown = module.between(earlier, later, 0.25)
        off = np.abs(shown["position"] - later["position"]).max()
        assert off < 1e-9, f"the sheet moves by {off} between frames {number} and {number + 1}"
        assert np.array_equal(shown["faces"], later["faces"])
        assert set(shown["fragment"]) <= set(earlier["fragment"])
        same = np.isin(later["fragment"], earlier["fragment"])
        moved = np.flatnonzero(shown["fragment"][same] != later["fragment"][same])
        assert len(moved) == 0, f"faces {moved} are of another piece before frame {number + 1}"
    print(f"the player keeps the sheet between {len(states)} frames where it is")


main(*sys.argv[1:])
