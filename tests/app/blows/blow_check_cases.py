#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""blow_check_cases.py: tests the checks of random impacts (blow_check.py) by motions with known results: passing
through, sliding past, bouncing, intersecting. Exit code 1: a check fails on a motion."""
import math
import pathlib
import sys
import tempfile
import types
import unittest

import numpy

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import blow_check  # noqa: E402
import blow_race  # noqa: E402
from blow_parts import Keys  # noqa: E402
from blow_solids import ball, closed_box, prism, turned  # noqa: E402


def grid(count=6, size=1.0):
    """Returns vertices and triangles of a square in the plane z = 0 about the origin."""
    corner = numpy.array([[x / count - 0.5, y / count - 0.5, 0] for x in range(count + 1) for y in range(count + 1)])
    faces = []
    for x in range(count):
        for y in range(count):
            i = (count + 1) * x + y
            faces += [(i, i + count + 1, i + 1), (i + 1, i + count + 1, i + count + 2)]
    return corner * size, numpy.array(faces)


def sheet(start, end, faces, name="sheet"):
    return blow_check.Surface(name, blow_check.SheetMotion(start, end), faces, True)


def solid(shape, start, end, name="solid"):
    """Returns the surface of a solid that moves straight from one place to another."""
    motion = blow_check.BodyMotion(shape[0], *[(numpy.eye(3), numpy.array(place, float)) for place in (start, end)])
    return blow_check.Surface(name, motion, shape[1], False)


def way(sheet_at, *places):
    """Returns whether a point that moves along `places` is on the other side of a pinned sheet at the end. sheet_at:
    for each place after the first, the positions of the sheet's vertices."""
    corner, faces = grid()
    rest = blow_check.Surface("sheet", blow_check.SheetMotion(corner, corner), faces, True)
    sides = blow_check.Sides("pinned", rest, numpy.array([places[0]], float))
    for place, now in zip(places[1:], sheet_at):
        beyond = sides.step([numpy.array([place], float)], now, True)
    return bool(beyond[0])


class Motions(unittest.TestCase):
    def test_rotation_vectors_are_those_of_their_rotations(self):
        chance = numpy.random.default_rng(1)
        for angle in (0, 1e-12, 1e-3, 1, 3, math.pi - 1e-6, math.pi):
            axis = chance.normal(size=3)
            vector = angle * axis / numpy.linalg.norm(axis)
            matrix = blow_check.rotation(vector)
            numpy.testing.assert_allclose(blow_check.rotation(blow_check.rotation_vector(matrix)), matrix, atol=1e-7)

    def test_screws_and_sheets_begin_and_end_where_they_should(self):
        corner, _ = closed_box(numpy.array([1, 2, 3.]))
        poses = [(blow_check.rotation(numpy.array(v)), numpy.array(s)) for v, s in
                 (([0.3, 0.2, 0.1], [1, 2, 3.]), ([1, -0.2, 0.5], [2, 2, 9.]))]
        motion = blow_check.BodyMotion(corner, *poses)
        flat = blow_check.SheetMotion(*[corner @ matrix.T + shift for matrix, shift in poses])
        for time, (matrix, shift) in zip((0, 1), poses):
            numpy.testing.assert_allclose(motion.at(time), corner @ matrix.T + shift, atol=1e-12)
            numpy.testing.assert_allclose(flat.at(time), corner @ matrix.T + shift, atol=1e-12)

    def test_what_turns_keeps_its_shape_on_the_way(self):
        corner, _ = grid()
        motion = blow_check.SheetMotion(corner, corner @ turned([1, 0, 0], 120).T)
        half, first = [numpy.linalg.norm(places, axis=1) for places in (motion.at(0.5), corner)]
        numpy.testing.assert_allclose(half, first, atol=1e-12)

    def test_keys_turn_over_several_turns(self):
        keys = Keys(0, 1, numpy.zeros(3), numpy.array([0, 0, 1.]), 720, numpy.zeros(3), False)
        motion = blow_check.KeyedMotion(numpy.array([[1, 0, 0.]]), keys, 0, 1)
        numpy.testing.assert_allclose(motion.at(0.25), [[-1, 0, 0]], atol=1e-12)


class Crossings(unittest.TestCase):
    def setUp(self):
        self.corner, self.faces = grid()
        self.still = sheet(self.corner, self.corner, self.faces)

    def count(self, one, other=None):
        return len(blow_check.crossings_of(self.still, one if other is None else other))

    def test_all_solids_that_jump_through_are_seen(self):
        boxes = [closed_box(numpy.array(size)) for size in ([0.3, 0.1, 0.2], [3, 3, 0.1])]
        for shape in (ball(0.1), prism(0.005, 0.6, 5), *boxes):
            self.assertGreater(self.count(solid(shape, [0.03, 0.02, 1], [0.05, 0.01, -1])), 0)
            self.assertGreater(self.count(solid(shape, [0.03, 0.02, 20], [0.05, 0.01, -30])), 0)

    def test_a_thin_wire_that_no_vertex_meets_is_seen(self):
        wire = prism(1e-4, 4, 3)
        corner = wire[0] @ turned([0, 1, 0], 90).T + [0, 0.043, 0]
        self.assertGreater(self.count(solid((corner, wire[1]), [0, 0, 0.1], [0, 0, -0.1])), 0)

    def test_what_goes_beside_or_turns_back_is_not(self):
        self.assertEqual(self.count(solid(ball(0.1), [0.62, 0, 1], [0.62, 0, -1])), 0)
        self.assertEqual(self.count(solid(ball(0.1), [0, 0, 1], [0.3, 0, 0.101])), 0)
        self.assertEqual(self.count(solid(ball(0.1), [-3, 0, 0.11], [3, 0, 0.11])), 0)

    def test_what_comes_back_within_the_frame_is_not(self):
        keys = Keys(0, 1, numpy.zeros(3), numpy.array([0, 1., 0]), 360, numpy.array([0.013, 0.021, 0.45]), False)
        rod = closed_box(numpy.array([0.05, 0.05, 1]))
        motion = blow_check.KeyedMotion(rod[0] + keys.centre, keys, 0, 1)
        self.assertEqual(self.count(blow_check.Surface("rod", motion, rod[1], False)), 0)

    def test_a_turning_rod_is_seen(self):
        keys = Keys(0, 1, numpy.zeros(3), numpy.array([0, 1., 0]), 90, numpy.array([0, 0, 0.1]), False)
        rod = closed_box(numpy.array([0.8, 0.05, 0.05]))
        motion = blow_check.KeyedMotion(rod[0] + keys.centre, keys, 0, 1)
        self.assertGreater(self.count(blow_check.Surface("rod", motion, rod[1], False)), 0)

    def test_depth_is_the_distance_from_the_rim(self):
        found = blow_check.crossings_of(self.still, solid(ball(0.01), [0.3, 0, 1], [0.3, 0, -1]))
        self.assertAlmostEqual(max(crossing.depth for crossing in found), 0.21, delta=0.02)

    def test_a_sheet_through_a_sheet_is_seen_and_both_that_fly_are_not(self):
        small = self.corner * 0.3
        other = sheet(small + [0, 0, 1], small + [0.01, 0.02, -1], self.faces, "other")
        self.assertGreater(self.count(other), 0)
        both = [sheet(c, c @ turned([1, 2, 3], 170).T + [5, 5, 5], self.faces, n) for c, n in
                ((self.corner, "one"), (small + [0, 0, 0.01], "two"))]
        centre = sheet(numpy.vstack([self.corner, small]), numpy.vstack([self.corner, small]), self.faces)
        self.assertEqual(len(blow_check.crossings_of(both[0], both[0])), 0)
        self.assertEqual(len(blow_check.crossings_of(centre, centre)), 0)

    def test_a_strip_that_folds_through_itself_is_seen(self):
        length = self.corner[:, 0] + 0.5

        def folded(height):  # beyond three fifths of its length the strip returns at this height, descending by 0.1
            back = numpy.maximum(length - 0.6, 0)
            z = numpy.where(back > 0, height - back / 4, 0)
            return numpy.stack([length - 2 * back, self.corner[:, 1], z], axis=1)
        for before, after, seen in ((0.3, 0.2, False), (0.3, -0.2, True), (-0.1, -0.3, False)):
            strip = sheet(folded(before), folded(after), self.faces)
            self.assertEqual(len(blow_check.crossings_of(strip, strip)) > 0, seen)
            self.assertEqual(blow_check.standing_crossings(strip, strip, 1), 0)
        self.assertGreater(blow_check.standing_crossings(*[sheet(folded(0.05), folded(0.05), self.faces)] * 2, 1), 0)

    def test_what_stands_across_is_seen_and_what_lies_near_is_not(self):
        self.assertGreater(blow_check.standing_crossings(self.still, solid(ball(0.1), [0, 0, 0], [0, 0, 0.05]), 1), 0)
        self.assertEqual(blow_check.standing_crossings(self.still, solid(ball(0.1), [0, 0, 0], [0, 0, 0.1001]), 1), 0)
        self.assertEqual(blow_check.standing_crossings(self.still, self.still, 1), 0)


class SidesOfSheets(unittest.TestCase):
    def setUp(self):
        self.flat, self.faces = grid()
        self.bag = self.flat.copy()
        self.bag[(abs(self.flat[:, :2]) < 0.49).all(axis=1), 2] = -2

    def test_a_pinned_sheet_is_passed_or_not(self):
        above, below, deep = [0.02, 0.03, 1], [0.03, 0.02, -1], [0.03, 0.02, -3]
        self.assertTrue(way([self.flat], above, below))
        self.assertFalse(way([self.bag], above, below))
        self.assertTrue(way([self.bag], above, deep))
        self.assertTrue(way([self.bag, self.flat], above, below, below))
        self.assertFalse(way([self.bag, self.flat], above, below, above))

    def test_round_the_rim_is_no_passage(self):
        self.assertFalse(way([self.flat] * 4, [0, 0, 1], [3, 0, 1], [3, 0, -1], [0.02, 0.03, -1]))

    def test_what_comes_near_the_rim_is_not_judged(self):
        self.assertFalse(way([self.flat], [0.45, 0, 1], [0.45, 0.01, -0.01]))

    def test_in_and_out_of_a_ball(self):
        corner, faces = ball(1.0)
        closed = blow_check.Surface("sheet", blow_check.SheetMotion(corner, corner), faces, True)
        points = numpy.array([[0, 0, 0], [0, 0.1, 2.]])
        for ends, beyond in ((points + [0, 0, 0.5], [False, False]), (points * [1, 1, 0], [False, True]),
                             (points + [3, 0, 0], [True, False])):
            sides = blow_check.Sides("closed", closed, points)
            self.assertEqual(list(sides.step([ends], corner, True)), beyond)

    def test_a_large_sheet_is_passed_or_pushed(self):
        large = blow_check.Surface("sheet", blow_check.SheetMotion(self.flat, self.flat), self.faces, True)
        for shift, beyond in ((0, True), (-0.05, False)):
            sides = blow_check.Sides("large", large, numpy.array([[0.01, 0.02, 0.03]]))
            found = sides.step([numpy.array([[0.01, 0.02, -0.03]])], self.flat + [0, 0, shift], True)
            self.assertEqual(found[0], beyond)


class StepsThatWereMade(unittest.TestCase):
    """A crossing between frames is dismissed only if no step of the program has one."""
    MODULE = """
import types
import numpy
{data}
class Simulation:
    def __init__(self, scene):
        self.scene, self.time, self.velocities = types.SimpleNamespace(sheets=["sheet"]), 0, 0 * positions[0]
    def step(self):
        self.time += 1
    def snapshot(self):
        return types.SimpleNamespace(masses=numpy.ones(len(positions[0])), faces=faces, face_sheets=0 * faces[:, 0])
    has_ended = property(lambda self: self.time + 1 == len(positions))
    positions = property(lambda self: positions[self.time])
    poses = property(lambda self: {{"solid": numpy.hstack([numpy.eye(3), places[self.time][:, None]])}})
"""

    def outcome(self, heights, fall=0.0, fault=""):
        """Returns outcome and explanation for a ball at these heights, the sheet lowered by `fall` at the last of them.
        fault: a statement that is appended to the module."""
        corner, faces = grid()
        positions = numpy.array([corner] * len(heights))
        positions[-1, :, 2] -= fall
        arrays = {"faces": faces, "positions": positions, "places": numpy.outer(heights, [0, 0, 1])}
        data = "\n".join(f"{name} = numpy.array({array.tolist()})" for name, array in arrays.items())
        solid, triangles = ball(0.05)
        blow = types.SimpleNamespace(solids={"solid": (solid + arrays["places"][0], triangles)}, turns={}, struck=None,
                                     border=None, speed=1)
        seen = types.SimpleNamespace(words=lambda: "it crossed", positions=[corner])
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "python").mkdir()
            (folder / "python/sherd.py").write_text(self.MODULE.format(data=data) + fault)
            return blow_race.by_each_step(folder / "sherd", folder, blow, seen, "why")

    def test_one_that_crosses_is_a_passage(self):
        outcome, words = self.outcome([0.2, -0.2])
        self.assertEqual(outcome, "passed", words)
        self.assertIn("of its 1 steps frame 1: sheet and solid", words)

    def test_none_that_crosses_is_none(self):
        self.assertEqual(self.outcome([0.2, 0.1, 0.2])[0], "held")

    def test_steps_that_end_elsewhere_prove_nothing(self):
        outcome, words = self.outcome([0.2, 0.1], fall=1e-9)
        self.assertEqual(outcome, "passed")
        self.assertIn("end elsewhere", words)

    def test_steps_that_cannot_be_made_prove_nothing(self):
        outcome, words = self.outcome([0.2, 0.1], fault="raise MemoryError")
        self.assertEqual(outcome, "passed")
        self.assertIn("could not be looked at", words)


if __name__ == "__main__":
    unittest.main()
