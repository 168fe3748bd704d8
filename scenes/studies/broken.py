# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether what falls breaks, and from how high it came."""

GRAVITY = 9.81  # m/s^2


def measure(recording):
    """broken: 1 when anything has cracked; height: m, of a fall to the speed at which it starts."""
    speed = abs(recording.frame(0).velocities[:, 2].mean())
    return {"broken": int(recording.measures()["crack_length"] > 0), "height": speed**2 / (2 * GRAVITY)}
