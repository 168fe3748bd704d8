# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the pieces of a pane as standards of tempered glass do."""
import numpy

HALF_WINDOW = 0.025  # m


def measure(recording):
    """Returns pieces_in_window: pieces on the middle 50 x 50 mm; pieces that this square's sides cut count half."""
    frame = recording.frame(len(recording) - 1)
    rest, piece = frame.rest_positions[:, :2], frame.face_fragments
    middles = rest[frame.rest_faces].mean(axis=1)
    inside = (abs(middles - rest.mean(axis=0)) < HALF_WINDOW).all(axis=1)
    whole, within = numpy.bincount(piece), numpy.bincount(piece[inside], minlength=piece.max() + 1)
    return {"pieces_in_window": (within == whole)[within > 0].sum() + 0.5 * (within < whole)[within > 0].sum()}
