# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures whether a falling object breaks, and the height of its fall."""

GRAVITY = 9.81  # m/s^2


def measure(recording):
    """Returns broken: 1 if anything has cracked, else 0; height: m, of a free fall that ends at the initial speed."""
    speed = abs(recording.frame(0).velocities[:, 2].mean())
    return {"broken": int(recording.measures()["crack_length"] > 0), "height": speed**2 / (2 * GRAVITY)}
