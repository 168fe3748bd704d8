# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of meshes that are given as arrays: sherd.cut(), sheets of a scene, and sherd.Mechanics."""
import unittest

import numpy

import sherd


def grid(cells, size):
    """Returns a square of 2 * cells^2 triangles: positions [V, 3], faces [F, 3], and vertices [cells + 1, cells + 1] by
    column and row."""
    x, y = numpy.meshgrid(numpy.linspace(0, size, cells + 1), numpy.linspace(0, size, cells + 1), indexing="ij")
    positions = numpy.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1)
    number = numpy.arange(len(positions)).reshape(cells + 1, cells + 1)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    faces = numpy.concatenate([numpy.stack(three, axis=-1).reshape(-1, 3) for three in ((a, b, c), (a, c, d))])
    return positions, faces, number


def scene(positions, faces, **more):
    return {"duration": 0.01, "sheet": {"square": {"mesh": {"positions": positions, "faces": faces, **more},
                                                   "material": {"preset": "glass"}}}}


class Cuts(unittest.TestCase):
    def setUp(self):
        self.positions, self.faces, self.number = grid(4, 0.1)

    def test_a_line_through_the_mesh_parts_it(self):
        line = self.number[2]
        cut = sherd.cut(self.positions, self.faces, numpy.stack([line[:-1], line[1:]], axis=1))
        self.assertEqual(cut.fragments.max() + 1, 2)
        self.assertEqual(len(cut.positions), len(self.positions) + len(line))
        numpy.testing.assert_array_equal(cut.originals[cut.faces], self.faces)
        numpy.testing.assert_array_equal(cut.positions, self.positions[cut.originals])
        self.assertEqual(sorted(cut.originals[len(self.positions):]), sorted(line))

    def test_an_edge_inside_stays_closed(self):
        cut = sherd.cut(self.positions, self.faces, [[self.number[1, 1], self.number[1, 2]]])
        self.assertEqual(len(cut.positions), len(self.positions))

    def test_edges_that_are_none_and_meshes_that_are_none_are_errors(self):
        n = self.number
        for edges, words in (([[n[0, 0], n[4, 4]]], r"edges\[0\]: there is no edge"), ([[0, 99]], "no edge"),
                             ([[n[0, 0], n[0, 1]]], "not interior"), ([0, 1], r"shape \[2\]"),
                             ([[6, 7.5]], r"edges\[0\]: 7.5 is no whole number"),
                             ([[n[1, 1], n[1, 2]], [n[1, 2], n[1, 1]]], "twice")):
            with self.assertRaisesRegex(sherd.Error, words):
                sherd.cut(self.positions, self.faces, edges)
        with self.assertRaisesRegex(sherd.Error, r"positions\[0\]: is not finite"):
            sherd.cut(self.positions * numpy.nan, self.faces, [[6, 7]])
        with self.assertRaisesRegex(sherd.Error, "vertex"):
            sherd.cut(self.positions, self.faces + 1, [[6, 7]])


class Sheets(unittest.TestCase):
    def setUp(self):
        self.positions, self.faces, self.number = grid(4, 0.1)

    def test_vertices_and_faces_keep_their_numbers(self):
        simulation = sherd.Simulation(scene(self.positions, self.faces))
        numpy.testing.assert_array_equal(simulation.positions, self.positions)
        numpy.testing.assert_array_equal(simulation.faces, self.faces)

    def test_several_sheets_stand_one_after_the_other(self):
        two = scene(self.positions, self.faces)
        two["sheet"]["other"] = {**two["sheet"]["square"], "place": {"translate": [0, 0, 1]}}
        two["sheet"]["disc"] = {"mesh": {"generate": "disc", "radius": 0.05, "edge_length": 0.02},
                                "material": {"preset": "glass"}, "place": {"translate": [0, 0, 2]}}
        simulation = sherd.Simulation(two)
        numpy.testing.assert_array_equal(simulation.positions[25:50], self.positions + [0, 0, 1])
        self.assertEqual(list(numpy.bincount(simulation.snapshot().face_sheets)[:2]), [32, 32])
        self.assertEqual(simulation.scene.sheets, ["square", "other", "disc"])

    def test_they_are_remeshed_where_asked_for(self):
        simulation = sherd.Simulation(scene(self.positions, self.faces, remesh=0.01))
        self.assertGreater(len(simulation.faces), 150)
        self.assertAlmostEqual(simulation.snapshot().rest_areas.sum(), 0.01)

    def test_what_is_no_mesh_is_an_error_of_the_sheet(self):
        with self.assertRaisesRegex(sherd.Error, "<dict>:.*sheet.square.mesh: .*vertex"):
            sherd.Simulation(scene(self.positions, self.faces + 1))
        with self.assertRaisesRegex(sherd.Error, r"square.faces: is an array of shape \[32, 2\]"):
            sherd.Scene(scene(self.positions, self.faces[:, :2]))
        with self.assertRaisesRegex(sherd.Error, "no program has passed a mesh of the name 'elsewhere'"):
            sherd.Simulation({"duration": 1, "sheet": {"a": {"mesh": {"given": "elsewhere"},
                                                             "material": {"preset": "glass"}}}})


class Mechanics(unittest.TestCase):
    def setUp(self):
        positions, faces, _ = grid(3, 0.1)
        random = numpy.random.default_rng(7)
        self.bent = positions + 1e-3 * random.standard_normal(positions.shape)
        self.scene = scene(positions, faces)

    def models(self):
        for bending in ("coupled", "cubic", "nonlinear"):
            for membrane in ("constant-strain", "arc"):
                yield sherd.Mechanics(sherd.Scene(self.scene, set={"solver.bending": bending,
                                                                   "solver.membrane": membrane}))

    def test_there_is_no_energy_at_rest(self):
        for mechanics in self.models():
            self.assertLess(abs(mechanics.energy(mechanics.rest_positions)), 1e-12)
            self.assertGreater(mechanics.energies(self.bent)["bending"], 0)
            self.assertGreater(mechanics.energies(self.bent)["membrane"], 0)

    def test_the_gradient_is_that_of_the_energy(self):
        random = numpy.random.default_rng(8)
        for mechanics in self.models():
            way, step = random.standard_normal(self.bent.shape), 1e-7
            slope = (mechanics.energy(self.bent + step * way) - mechanics.energy(self.bent - step * way)) / (2 * step)
            self.assertAlmostEqual((mechanics.gradient(self.bent) * way).sum() / slope, 1, places=5)

    def test_the_hessian_is_that_of_the_energy(self):
        random = numpy.random.default_rng(9)
        for mechanics in self.models():
            hessian = mechanics.hessian(self.bent)
            self.assertEqual(hessian.shape, (self.bent.size, self.bent.size))
            self.assertEqual(abs(hessian - hessian.T).max(), 0)
            way, step = random.standard_normal(self.bent.shape), 1e-7
            ahead, behind = (mechanics.gradient(self.bent + sign * step * way) for sign in (1, -1))
            change = (ahead - behind) / (2 * step)
            numpy.testing.assert_allclose(hessian @ way.ravel(), change.ravel(), rtol=0, atol=1e-5 * abs(change).max())

    def test_fields_of_faces_are_those_of_a_stretch(self):
        mechanics = sherd.Mechanics(self.scene)
        fields = mechanics.fields(mechanics.rest_positions * [1.001, 1, 1])
        strain = fields["membrane_strain"]
        numpy.testing.assert_allclose(strain[:, 0] + strain[:, 1], (1.001**2 - 1) / 2, rtol=1e-9)
        numpy.testing.assert_allclose(fields["curvature"], 0, atol=1e-9)
        numpy.testing.assert_allclose(fields["stress_top"], fields["stress_bottom"], rtol=1e-9, atol=1)

    def test_other_shapes_are_errors(self):
        mechanics = sherd.Mechanics(self.scene)
        for ask in (mechanics.energy, mechanics.gradient, mechanics.hessian, mechanics.fields):
            with self.assertRaisesRegex(sherd.Error, "has 15 rows, and the sheets have 16 vertices"):
                ask(self.bent[1:])


if __name__ == "__main__":
    unittest.main()
