# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of changes that Python makes between two steps: forces, motions, failure of edges."""
import unittest

import numpy

import sherd

STEP = 1e-4
SQUARE = {
    "duration": 1,
    "sheet": {"square": {"mesh": {"generate": "rectangle", "width": 0.1, "height": 0.1, "edge_length": 0.02,
                                  "structured": True},
                         "material": {"preset": "glass"}, "velocity": [1, 0, 0]}},
    "force": {"gravity": [0, 0, 0]},
    "solver": {"step": STEP},
}
HELD = {**SQUARE, "sheet": {"square": {**SQUARE["sheet"]["square"], "velocity": [0, 0, 0],
                                       "pin": {"box": [[-1, -1, -1], [0.001, 1, 1]]}}}}
SCHEMES = ("implicit-euler", "explicit")


def made(scene, scheme):
    return sherd.Simulation(sherd.Scene(scene, set={"solver.scheme": scheme}))


def middle_line(simulation):
    """Returns the edges [n, 2] along a line of constant x that divides the square."""
    state = simulation.snapshot()
    x = state.rest_positions[:, 0]
    line = numpy.unique(x.round(9))[2]
    return state.edges[(abs(x[state.edges] - line) < 1e-6).all(1)]


class Forces(unittest.TestCase):
    def test_they_accelerate_what_they_act_on(self):
        for scheme in SCHEMES:
            simulation = made(SQUARE, scheme)
            wanted = numpy.array([0, 3.0, -2.0])  # m/s^2
            simulation.set_forces(simulation.masses[:, None] * wanted)
            simulation.run(until=10 * STEP)
            numpy.testing.assert_allclose(simulation.velocities, [[1, 0, 0] + wanted * simulation.time] *
                                          len(simulation.masses), atol=2e-4 if scheme == "explicit" else 1e-6)
            self.assertGreater(simulation.report.work_of_loads, 0)
            self.assertLess(abs(simulation.report.unexplained), 1e-6 * simulation.report.work_of_loads)
            simulation.set_forces(None)
            simulation.step()
            before = simulation.velocities
            simulation.step()
            numpy.testing.assert_allclose(simulation.velocities, before, atol=1e-6)

    def test_they_may_be_others_at_each_step(self):
        simulation = made(SQUARE, "implicit-euler")
        impulse = numpy.zeros(3)
        for step in range(5):
            forces = numpy.zeros_like(simulation.positions)
            forces[3] = [0, 1e-3 * step, 0]
            simulation.set_forces(forces)
            impulse += simulation.step().step_size * forces.sum(0)
        gained = simulation.report.linear_momentum - simulation.masses.sum() * numpy.array([1, 0, 0])
        numpy.testing.assert_allclose(gained, impulse, atol=1e-12)

    def test_copies_of_a_vertex_share_its_force(self):
        for scheme in SCHEMES:
            simulation = made(SQUARE, scheme)
            simulation.set_forces(simulation.masses[:, None] * [0, 0, 5.0])
            simulation.break_edges(middle_line(simulation))
            simulation.run(until=4 * STEP)
            self.assertEqual(simulation.report.fragments, 2)
            numpy.testing.assert_allclose(simulation.velocities[:, 2], 5 * simulation.time,
                                          rtol=0.2 if scheme == "explicit" else 1e-6)

    def test_nothing_else_is_taken(self):
        simulation = made(SQUARE, "implicit-euler")
        for forces, words in ((numpy.zeros((3, 3)), "forces: has 3 rows"), (numpy.zeros(3), "shape"),
                              (numpy.full_like(simulation.positions, numpy.inf), "not finite")):
            with self.assertRaisesRegex(sherd.Error, words):
                simulation.set_forces(forces)


class Motions(unittest.TestCase):
    def test_pinned_vertices_go_where_they_are_told(self):
        for scheme in SCHEMES:
            simulation = made(HELD, scheme)
            held = numpy.flatnonzero(simulation.pinned)
            start = simulation.positions[held]
            self.assertGreater(len(held), 3)
            for step in range(1, 6):
                places = start + [0, 0, 1e-5 * step**2]
                simulation.prescribe(held, places, simulation.time + STEP)
                simulation.run(until=step * STEP)
                numpy.testing.assert_allclose(simulation.positions[held], places, atol=1e-12)
            self.assertGreater(simulation.report.work_of_supports, 0)
            self.assertGreater(numpy.linalg.norm(simulation.reactions["sheet.square.pin"][0]), 0)
            simulation.run(until=7 * STEP)  # the vertices stay there
            numpy.testing.assert_allclose(simulation.positions[held], places, atol=1e-12)

    def test_each_has_a_way_of_its_own_also_when_it_has_split(self):
        simulation = made(HELD, "implicit-euler")
        state = simulation.snapshot()
        y = state.positions[:, 1]
        row = numpy.unique(y.round(9))[2]
        held = numpy.flatnonzero(simulation.pinned)
        simulation.prescribe(held, simulation.positions[held], STEP)  # prescribed motions, which copies inherit
        simulation.step()
        simulation.break_edges(state.edges[(abs(y[state.edges] - row) < 1e-6).all(1)])
        held = numpy.flatnonzero(simulation.pinned)
        self.assertEqual(len(held), state.edges[(state.positions[state.edges][:, :, 0] < 0.001).all(1)].shape[0] + 2)
        places = simulation.positions[held] + 1e-6 * numpy.arange(3 * len(held)).reshape(-1, 3)
        for share in (0.5, 1):
            between = simulation.positions[held] * (1 - share) + places * share
            simulation.prescribe(held, between, simulation.time + STEP)
            simulation.step()
        numpy.testing.assert_allclose(simulation.positions[held], places, atol=1e-12)

    def test_what_nothing_holds_is_not_told(self):
        simulation = made(HELD, "implicit-euler")
        free = numpy.flatnonzero(~simulation.pinned)[:1]
        held = numpy.flatnonzero(simulation.pinned)[:1]
        with self.assertRaisesRegex(sherd.Error, f"vertex {free[0]} cannot follow prescribed positions"):
            simulation.prescribe(free, simulation.positions[free], 1)
        with self.assertRaisesRegex(sherd.Error, "vertex -1"):
            simulation.prescribe([-1], simulation.positions[held], 1)
        with self.assertRaisesRegex(sherd.Error, "the time is 0 already"):
            simulation.prescribe(held, simulation.positions[held], 0)
        with self.assertRaisesRegex(sherd.Error, "has 2 rows, not 1"):
            simulation.prescribe(held, simulation.positions[:2], 1)


class Breaking(unittest.TestCase):
    def test_a_line_of_edges_parts_the_sheet(self):
        for scheme in SCHEMES:
            for steps in (0, 3):
                simulation = made(SQUARE, scheme)
                simulation.run(until=steps * STEP)
                momentum, line = simulation.masses @ simulation.velocities, middle_line(simulation)
                simulation.break_edges(line)
                state = simulation.snapshot(fields=["stress"])
                self.assertEqual(state.face_fragments.max(), 1)
                self.assertEqual(len(simulation.events["failure"]["edge"]), 0)  # events come with the next step
                numpy.testing.assert_allclose(simulation.masses @ simulation.velocities, momentum, atol=1e-12)
                simulation.run(until=(steps + 2) * STEP)
                self.assertEqual(simulation.report.fragments, 2)
                self.assertEqual(len(simulation.events["failure"]["edge"]), len(line))
                self.assertEqual(set(simulation.events["failure"]["step"]), {steps})
                self.assertLess(abs(simulation.report.unexplained), 1e-9)

    def test_what_it_stored_is_lost_to_cracks(self):
        bent = {**SQUARE, "sheet": {"square": {**SQUARE["sheet"]["square"], "velocity": [0, 0, 0],
                                               "bend": {"curvature": 2}}}}
        for scheme in SCHEMES:
            simulation, whole = made(bent, scheme), made(bent, scheme)
            for one in (simulation, whole):
                one.step()
            stored = simulation.report.bending
            simulation.break_edges(middle_line(simulation))
            for one in (simulation, whole):
                one.step()
            self.assertGreater(simulation.report.lost_to_cracks, 1e-3 * stored)
            self.assertEqual(whole.report.lost_to_cracks, 0)
            self.assertLess(abs(simulation.report.unexplained), 0.05 * simulation.report.lost_to_cracks)

    def test_what_cannot_fail_is_said(self):
        simulation = made(SQUARE, "implicit-euler")
        line = middle_line(simulation)
        border = simulation.snapshot().edges[simulation.snapshot().edge_states == 2][:1]
        for edges, words in ((line[[0, 0]], "given twice"), (border, "on the boundary"), ([[0, 0]], "no edge")):
            with self.assertRaisesRegex(sherd.Error, words):
                simulation.break_edges(edges)
        simulation.break_edges(line[1:2])
        with self.assertRaisesRegex(sherd.Error, "has failed already"):
            simulation.break_edges(line[1:2])


if __name__ == "__main__":
    unittest.main()
