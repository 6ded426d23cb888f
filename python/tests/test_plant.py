"""Machines in time: steps, runs, and controllers in Python."""

import copy
import pickle
import unittest

import numpy as np

import cdpr
from test_answers import scenario, _moving

POSE = [0.0, 0.0, 1.5, 0.0, 0.0, 0.0]


class Steps(unittest.TestCase):
    def setUp(self) -> None:
        self.plant = cdpr.Plant(_moving())
        self.start = self.plant.at_rest(POSE, self.plant.model.tensions(POSE, "closed-form").tensions)

    def test_a_machine_at_rest_stays(self) -> None:
        state = self.start.copy()
        for _ in range(100):
            self.plant.step(state, state.lengths, 0.001)
        self.assertAlmostEqual(state.time, 0.1, places=12)
        np.testing.assert_allclose(state.pose, self.start.pose, rtol=0, atol=1e-9)

    def test_one_call_a_step_and_one_call_for_all_give_the_same_bits(self) -> None:
        lengths = self.start.lengths + 0.002 * np.sin(np.linspace(0.0, 6.0, 400))[:, None]
        stepped, run = self.start.copy(), copy.copy(self.start)
        for row in lengths:
            self.plant.step(stepped, row, 0.001)
        motion = self.plant.run(run, lengths, 0.001, every=100)
        self.assertIsNone(motion.reason)
        self.assertEqual(motion.poses.shape, (5, 7))
        self.assertEqual(stepped, run)
        np.testing.assert_array_equal(motion.poses[-1], stepped.pose)
        out = np.empty(7 + 6 + 8)
        np.testing.assert_array_equal(stepped.observe(out)[:7], stepped.pose)
        np.testing.assert_array_equal(out[13:], stepped.tensions)

    def test_a_step_that_cannot_be_taken_is_an_error_or_ends_a_run(self) -> None:
        with self.assertRaises(cdpr.Error):
            self.plant.step(self.start.copy(), np.full(8, np.nan), 0.001)
        motion = self.plant.run(self.start.copy(), np.full((3, 8), np.nan), 0.001)
        self.assertTrue(motion.reason)
        with self.assertRaises(cdpr.Error):
            self.plant.step(self.start.copy(), np.zeros(7), 0.001)

    def test_the_environment_keeps_the_rules_of_gymnasium(self) -> None:
        try:
            from gymnasium.utils.env_checker import check_env
        except ImportError:
            self.skipTest("gymnasium is not there")
        from cdpr.gym import PlantEnv

        env = PlantEnv(self.plant, self.start, reward=lambda seen, action: -float(np.abs(action).sum()), displacement=1e-3)
        check_env(env, skip_render_check=True)


class Hold:
    """Sends the lengths of the start, as the scenario's own controller does."""

    def __init__(self) -> None:
        self.calls, self.resets = 0, 0

    def command(self, time: float, wanted: cdpr.Setpoint, measured: cdpr.Measured) -> np.ndarray:
        self.calls += 1
        assert measured.tensions.shape == (8,) and wanted.pose.shape == (7,)
        return wanted.lengths

    def reset(self) -> None:
        self.resets += 1


class GiveWay:
    """Winches that give way to what exceeds the tensions of the first look: they damp."""

    kind, period = "speeds", 0.005

    def __init__(self) -> None:
        self.level: np.ndarray | None = None

    def command(self, time: float, wanted: cdpr.Setpoint, measured: cdpr.Measured) -> np.ndarray:
        if self.level is None:
            self.level = measured.tensions
        return 3e-5 * (measured.tensions - self.level)


class Broken:
    def command(self, time: float, wanted: cdpr.Setpoint, measured: cdpr.Measured) -> np.ndarray:
        raise RuntimeError("no idea")


class Controllers(unittest.TestCase):
    def test_holding_in_python_is_holding(self) -> None:
        ours = cdpr.run(scenario(), controller=Hold())
        theirs = cdpr.run(scenario())
        self.assertEqual(ours.attached["result/log.csv"], theirs.attached["result/log.csv"])
        self.assertEqual(len(ours.table["t_s"]), len(ours.to_pandas()))

    def test_speeds_are_commands_and_damp(self) -> None:
        long = cdpr.Scenario.from_toml(
            scenario().to_toml().replace("duration_s = 0.05", "duration_s = 1.0"), scenario()._files
        )
        held, damped = cdpr.run(long), cdpr.run(long, controller=GiveWay())
        self.assertEqual(damped.status, "completed")
        shake = [float(np.ptp(run.table["x_m"][-20:])) for run in (held, damped)]
        self.assertLess(shake[1], 0.8 * shake[0])

    def test_sensors_give_samples_with_the_poses_of_the_tracker(self) -> None:
        sensors = {"rate_Hz": 100, "encoders": {"resolution_m": 1e-4}}
        tracker = {"rate_Hz": 120, "position_noise_m": 1e-3, "rotation_noise_rad": 1e-3}
        machine = cdpr.Scenario.of(_moving(), pose=POSE, duration=2.0, tables={"sensors": {**sensors, "tracker": tracker}})
        samples = cdpr.run(machine).to_samples(merge=True, static=True)
        self.assertEqual(pickle.loads(pickle.dumps(samples)), samples)
        rated = cdpr.evaluate("cablerobot-simulator-helicopter-elastostatic-calibrated", samples)
        self.assertLess(rated.samples, 10)
        blind = cdpr.Scenario.of(_moving(), pose=POSE, duration=0.05, tables={"sensors": sensors})
        with self.assertRaisesRegex(cdpr.Error, "no tracker"):
            cdpr.run(blind).to_samples(merge=True)

    def test_exceptions_of_a_controller_are_raised(self) -> None:
        with self.assertRaisesRegex(RuntimeError, "no idea"):
            cdpr.run(scenario(), controller=Broken())
        with self.assertRaises(cdpr.Error):
            cdpr.run(scenario(), controller=type("Odd", (Hold,), {"kind": "wishes"})())


if __name__ == "__main__":
    unittest.main()
