# SPDX-License-Identifier: GPL-3.0-or-later
"""python_simulation.py SHERD: tests sherd.Simulation against the program, and errors, interruption and threads."""
import _thread
import pathlib
import subprocess
import sys
import tempfile
import threading
import unittest
import warnings

import h5py
import numpy

import sherd

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
SQUARE = {
    "duration": 0.002,
    "sheet": {"square": {
        "mesh": {"generate": "rectangle", "width": 0.1, "height": 0.1, "edge_length": 0.02},
        "place": {"rotate": {"axis": [1, 0.5, 0], "degrees": 80}, "translate": [0, 0, 0.056]},
        "velocity": [0, 0, -5],
        "material": {"preset": "glass"},
        "fracture": {"strain": 1e-3},
    }},
    "obstacle": {"floor": {"plane": {}}},
    "solver": {"step": 1e-4},
}


def recorded(folder, *arguments):
    """Returns a recording that the program has made."""
    file = pathlib.Path(folder) / "program.h5"
    subprocess.run([PROGRAM, "run", *map(str, arguments), "-o", file], check=True, capture_output=True)
    return file


class Bits(unittest.TestCase):
    def same_as_program(self, scene, **set):
        arguments = [word for key, value in set.items() for word in ("--set", f"{key.replace('__', '.')}={value}")]
        with tempfile.TemporaryDirectory() as folder, h5py.File(recorded(folder, scene, *arguments)) as file:
            simulation = sherd.Simulation(sherd.Scene(scene, set={k.replace("__", "."): v for k, v in set.items()}))
            self.assertTrue(simulation.run())
            state, last = simulation.snapshot(), list(file["frames"].values())[-1]
            self.assertEqual(state.time, last.attrs["time"])
            for mine, name in ((state.positions, "vertex/position"), (state.velocities, "vertex/velocity"),
                               (state.faces, "face/vertices"), (state.face_fragments, "face/fragment"),
                               (state.edges, "edge/vertices"), (state.edge_states, "edge/state"),
                               (state.edge_strains, "edge/strain"), (state.masses, "vertex/mass"),
                               (state.originals, "vertex/original"), (state.rest_positions, "rest/position")):
                self.assertEqual(mine.tobytes(), last[name][:].tobytes(), name)
            names = [name.decode() for name in file["obstacles/names"]]
            self.assertEqual(sorted(simulation.poses), sorted(names))
            for name, pose in zip(names, last["obstacle/pose"][:]):
                self.assertEqual(simulation.poses[name][:3].tobytes(), pose.tobytes(), name)
            return simulation

    def test_implicit_steps_that_break_are_those_of_the_program(self):
        simulation = self.same_as_program(SCENES / "plate_drop.toml", duration=2e-3)
        self.assertEqual(simulation.report.step, 20)

    def test_explicit_steps_are_those_of_the_program(self):
        self.same_as_program(SCENES / "window_ball.toml", duration=4e-5)

    def test_a_dict_is_the_scene_that_its_text_is(self):
        ours = sherd.Scene(SQUARE)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "square.toml"
            file.write_text(ours.text)
            theirs = sherd.Scene(file)
        states = []
        for scene in (ours, theirs):
            simulation = sherd.Simulation(scene)
            simulation.run(until=5e-4)
            states.append(simulation.positions.tobytes())
        self.assertEqual(*states)

    def test_threads_step_two_simulations_at_once(self):
        alone = sherd.Simulation(SQUARE)
        alone.run()
        both = [sherd.Simulation(SQUARE), sherd.Simulation(SQUARE)]
        threads = [threading.Thread(target=one.run) for one in both]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for one in both:
            self.assertEqual(one.positions.tobytes(), alone.positions.tobytes())
            self.assertGreater(one.report.fragments, 1)


class State(unittest.TestCase):
    def test_arrays_have_their_shapes_and_snapshots_never_change(self):
        simulation = sherd.Simulation(SQUARE)
        before = simulation.snapshot(fields=["stress", "curvature", "membrane_strain"])
        copy = before.positions.copy()
        vertices, faces, edges = len(before.positions), len(before.faces), len(before.edges)
        self.assertEqual(vertices - edges + faces, 1)
        self.assertEqual(before.stress_top.shape, (faces, 3))
        self.assertEqual(before.velocities.shape, (vertices, 3))
        self.assertEqual(before.edge_states.shape, (edges,))
        self.assertIsNone(simulation.snapshot().curvature)
        self.assertFalse(before.positions.flags.writeable)
        with self.assertRaises(ValueError):
            before.positions[0] = 0
        simulation.run()
        numpy.testing.assert_array_equal(before.positions, copy)
        self.assertGreater(len(simulation.positions), vertices)
        view = simulation.snapshot().positions  # the view alone keeps its snapshot alive
        numpy.testing.assert_array_equal(view, simulation.positions)

    def test_copies_are_the_callers_own(self):
        simulation = sherd.Simulation(SQUARE)
        simulation.positions[:] = 0
        self.assertGreater(abs(simulation.positions).max(), 0.01)

    def test_masses_and_energies_are_those_of_the_sheet(self):
        simulation = sherd.Simulation(SQUARE)
        self.assertIsNone(simulation.report)
        report = simulation.step()
        speed = (simulation.velocities**2).sum(1)
        self.assertAlmostEqual(report.kinetic, 0.5 * simulation.masses @ speed, places=12)
        numpy.testing.assert_allclose(report.linear_momentum, simulation.masses @ simulation.velocities, rtol=1e-12)
        self.assertEqual((report.step, simulation.time), (1, 1e-4))
        kept = simulation.report
        simulation.step()
        self.assertEqual((kept.step, simulation.report.step), (1, 2))

    def test_events_tell_what_broke(self):
        simulation = sherd.Simulation(SQUARE)
        simulation.run()
        failed = simulation.events["failure"]["edge"]
        self.assertTrue((simulation.snapshot().edge_states[failed] > 0).all())
        self.assertEqual(len(simulation.events["fragment"]["fragment"]) + 1, simulation.report.fragments)

    def test_observers_end_a_run_and_times_do(self):
        simulation = sherd.Simulation(SQUARE)
        self.assertFalse(simulation.run(observe=lambda report: report.step == 3))
        self.assertEqual(simulation.report.step, 3)
        self.assertTrue(simulation.run(until=5e-4))
        self.assertEqual(simulation.report.step, 5)
        self.assertTrue(simulation.run())
        self.assertEqual(simulation.time, 0.002)

    def test_warnings_are_pythons(self):
        thick = {**SQUARE, "sheet": {"square": {**SQUARE["sheet"]["square"], "material": {
            "preset": "glass", "thickness": 0.012}}}}
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            simulation = sherd.Simulation(thick)
        self.assertEqual([str(one.message) for one in caught], simulation.warnings)
        self.assertGreater(len(caught), 0)


class Errors(unittest.TestCase):
    def test_mistakes_have_the_words_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "wrong.toml"
            file.write_text("duraton = 1\n")
            said = subprocess.run([PROGRAM, "run", file], capture_output=True, text=True).stderr
            with self.assertRaises(sherd.Error) as caught:
                sherd.Scene(file)
        self.assertEqual([f"sherd: error: {line}" for line in str(caught.exception).splitlines()], said.splitlines())
        self.assertEqual(caught.exception.fault, "input")
        self.assertIn("did you mean 'duration'", str(caught.exception))

    def test_a_dict_tells_its_keys(self):
        with self.assertRaisesRegex(sherd.Error, r"<dict>:\d+: sheet.square.material.yong: unknown key"):
            sherd.Scene({**SQUARE, "sheet": {"square": {**SQUARE["sheet"]["square"], "material": {
                "preset": "glass", "yong": 1e9}}}})
        with self.assertRaisesRegex(TypeError, "set"):
            sherd.Scene({"duration": {1, 2}})
        for wrong in ({"sheet": 3}, {"sheet": {"square": 3}},
                      {"sheet": {"square": {"mesh": {"positions": [[0, 0, 0]]}}}}):
            with self.assertRaisesRegex(sherd.Error, "<dict>"):
                sherd.Scene({"duration": 1, **wrong})

    def test_values_of_all_kinds_become_toml(self):
        scene = sherd.Scene({**SQUARE, "duration": numpy.float64(0.25), "seed": numpy.int64(3), "sheet": {"a \"b\"": {
            **SQUARE["sheet"]["square"], "velocity": numpy.array([0, 0, -1]), "mesh": pathlib.Path("other/bowl.obj")}}})
        self.assertEqual((scene.duration, scene.sheets), (0.25, ["a \"b\""]))
        self.assertIn('mesh = "other/bowl.obj"', scene.text)

    def test_overrides_and_variants_count(self):
        self.assertEqual(sherd.Scene(SQUARE, set={"solver.step": 5e-5, "sheet.square.velocity": [0, 0, 0]}).step, 5e-5)
        with self.assertRaisesRegex(sherd.Error, "--set solver.stp=1e-05"):
            sherd.Scene(SQUARE, set={"solver.stp": 1e-5})
        with self.assertRaisesRegex(sherd.Error, "no variant"):
            sherd.Scene(SQUARE, variant="other")

    def test_a_step_that_cannot_be_solved_is_an_error_of_the_run(self):
        simulation = sherd.Simulation(sherd.Scene(SQUARE, set={"solver.max_iterations": 1, "solver.tolerance": 1e-15}))
        with self.assertRaisesRegex(sherd.Error, "cannot be solved within 1 iterations") as caught:
            simulation.run()
        self.assertEqual(caught.exception.fault, "run")


class Interruption(unittest.TestCase):
    def test_ctrl_c_ends_after_the_step(self):
        simulation, undisturbed = sherd.Simulation(SQUARE), sherd.Simulation(SQUARE)

        def interrupt(report):
            if report.step == 2:
                _thread.interrupt_main()  # same effect as Ctrl-C

        with self.assertRaises(KeyboardInterrupt):
            simulation.run(observe=interrupt)
        self.assertGreaterEqual(simulation.report.step, 2)
        self.assertLess(simulation.time, 0.002)
        self.assertTrue(simulation.run())
        undisturbed.run()
        self.assertEqual(simulation.positions.tobytes(), undisturbed.positions.tobytes())

    def test_python_ends_while_a_daemon_thread_steps(self):
        text = f"""import threading, sherd
begun = threading.Event()
def step():
    simulation = sherd.Simulation({{**{SQUARE}, "duration": 100.0}})
    while True:
        simulation.step()
        begun.set()
threading.Thread(target=step, daemon=True).start()
begun.wait()
print("the program ends here")
"""
        for _ in range(5):
            done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=300)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "the program ends here\n", ""))

    def test_other_threads_run_meanwhile_and_may_not_look(self):
        simulation = sherd.Simulation(sherd.Scene(SCENES / "plate_drop.toml", set={"duration": 0.02}))
        errors, stop = [], threading.Event()

        def look():
            while not stop.is_set():
                try:
                    simulation.positions
                except sherd.Error as error:
                    errors.append(error)
                    return

        thread = threading.Thread(target=look)
        thread.start()
        while thread.is_alive() and simulation.time < 0.02:
            try:
                simulation.step()
            except sherd.Error as error:  # the other thread was reading at that time
                self.assertIn("another thread", str(error))
        stop.set()
        thread.join()
        self.assertIn("another thread", str(errors[0]))


if __name__ == "__main__":
    unittest.main()
