"""Robots and models on arrays, against formulas of numpy."""

import copy
import pickle
import unittest

import numpy as np

import cdpr

HELICOPTER = "cablerobot-simulator-helicopter"
ELASTIC = "cablerobot-simulator-helicopter-elastostatic-calibrated"


def angles(count: int, seed: int = 1) -> np.ndarray:
    draw = np.random.default_rng(seed)
    return np.hstack([draw.uniform(-1.0, 1.0, (count, 3)) + [0.0, 0.0, 2.0], draw.uniform(-0.1, 0.1, (count, 3))])


def turned(rows: np.ndarray) -> np.ndarray:
    """Rotation matrices Rx Ry Rz."""
    (sx, sy, sz), (cx, cy, cz) = np.sin(rows[:, 3:]).T, np.cos(rows[:, 3:]).T
    zero, one = np.zeros_like(sx), np.ones_like(sx)
    x = np.array([[one, zero, zero], [zero, cx, -sx], [zero, sx, cx]])
    y = np.array([[cy, zero, sy], [zero, one, zero], [-sy, zero, cy]])
    z = np.array([[cz, -sz, zero], [sz, cz, zero], [zero, zero, one]])
    return np.einsum("ijn,jkn,kln->nil", x, y, z)


class Lengths(unittest.TestCase):
    def setUp(self) -> None:
        self.robot = cdpr.Robot(HELICOPTER)
        self.model = cdpr.Model(self.robot)
        self.rows = angles(1000)

    def test_lengths_are_distances_of_anchors(self) -> None:
        ends = self.rows[:, None, :3] + np.einsum("nij,mj->nmi", turned(self.rows), self.robot.platform_anchors)
        expected = np.linalg.norm(self.robot.frame_anchors[None] - ends, axis=2)
        np.testing.assert_allclose(self.model.inverse(self.rows), expected, rtol=0, atol=1e-13)

    def test_forms_of_poses_and_orders_of_memory_give_the_same_bits(self) -> None:
        poses = self.robot.quaternions(self.rows)
        expected = self.model.inverse(poses)
        wide = np.zeros((2000, 9))
        wide[::2, 1:8] = poses
        for strided in (np.asfortranarray(poses), wide[::2, 1:8], poses[::-1][::-1]):
            np.testing.assert_array_equal(self.model.inverse(strided), expected)
        np.testing.assert_array_equal(self.model.inverse(poses[3]), expected[3])
        np.testing.assert_array_equal(self.model.inverse(poses[3].tolist()), expected[3])
        np.testing.assert_allclose(self.model.inverse(self.rows), expected, rtol=0, atol=1e-14)

    def test_out_is_written_and_returned(self) -> None:
        out = np.empty((1000, 8))
        self.assertIs(self.model.inverse(self.rows, out=out), out)
        np.testing.assert_array_equal(out, self.model.inverse(self.rows))
        single = np.empty(8)
        self.assertIs(self.model.inverse(self.rows[0], out=single), single)
        np.testing.assert_array_equal(single, out[0])

    def test_arrays_that_do_not_fit_are_refused_with_a_remedy(self) -> None:
        frozen = np.empty((1000, 8))
        frozen.flags.writeable = False
        refused = [
            (lambda: self.model.inverse(self.rows.astype(np.float32)), "np.asarray"),
            (lambda: self.model.inverse(self.rows[:, :5]), "(N, 7)"),
            (lambda: self.model.inverse(self.rows, out=np.empty((999, 8))), "(1000, 8)".replace("(", "[").replace(")", "]")),
            (lambda: self.model.inverse(self.rows, out=frozen), "written to"),
            (lambda: self.model.inverse(self.rows, out=np.empty((8, 1000)).T), "contiguous"),
            (lambda: self.model.inverse("home"), "numbers"),
        ]
        for call, words in refused:
            with self.assertRaises(cdpr.Error) as caught:
                call()
            self.assertEqual(caught.exception.code, "array::unfit")
            self.assertIn(words, str(caught.exception))

    def test_a_row_that_is_no_pose_is_named(self) -> None:
        poses = self.robot.quaternions(self.rows)
        poses[417, 3] = 2.0
        for given in (poses, np.asfortranarray(poses)):
            with self.assertRaises(cdpr.Error) as caught:
                self.model.inverse(given)
            self.assertEqual(caught.exception.code, "rows::not-a-rotation")


class Statics(unittest.TestCase):
    def setUp(self) -> None:
        self.model = cdpr.Model(ELASTIC, "elastic")
        self.poses = self.model.robot.quaternions(angles(200))

    def test_lengths_under_tensions_lead_back_to_the_poses(self) -> None:
        tensions = self.model.tensions(self.poses)
        lengths = self.model.inverse(self.poses)
        known = tensions.feasible
        self.assertTrue(known.mean() > 0.9)
        self.assertTrue(np.isnan(lengths[~known]).all())
        forward = self.model.forward(lengths[known], self.poses[known]).raise_for_status()
        np.testing.assert_allclose(forward.poses, self.poses[known], rtol=0, atol=1e-9)
        np.testing.assert_allclose(forward.tensions, tensions.tensions[known], rtol=0, atol=1e-4)

    def test_tensions_balance_the_load_within_limits(self) -> None:
        matrices = self.model.structure_matrix(self.poses)
        weight = np.array([0.0, 0.0, -5000.0, 0.0, 0.0, 0.0])
        found = self.model.tensions(self.poses, limits=(500.0, 12000.0), wrench=weight)
        self.assertTrue(found.feasible.any())
        left = np.einsum("nij,nj->ni", matrices, found.tensions) + weight
        self.assertLess(np.abs(left[found.feasible]).max(), 1e-6)
        self.assertTrue((found.tensions[found.feasible] >= 500.0 - 1e-6).all())
        np.testing.assert_array_equal(
            self.model.feasible(self.poses, limits=(500.0, 12000.0), wrench=weight), found.feasible
        )

    def test_criteria_by_name_are_masks_and_margins(self) -> None:
        mask = self.model.satisfies(self.poses, "wrench-feasible")
        np.testing.assert_array_equal(mask, self.model.feasible(self.poses))
        margins = self.model.margins(self.poses, "wrench-feasible")
        np.testing.assert_array_equal(margins.margin >= 0.0, mask)
        self.assertTrue(margins.unit)
        both = self.model.satisfies(self.poses, ["wrench-feasible", "wrench-closure"])
        self.assertTrue((both <= mask).all())
        with self.assertRaises(cdpr.Error):
            self.model.satisfies(self.poses, "no-such-criterion")

    def test_tensions_that_balance_nothing_are_none(self) -> None:
        outside = [[0.0, 0.0, 30.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.5, 0.0, 0.0, 0.0]]
        out = np.empty((2, 8))
        found = self.model.tensions(outside, out=out)
        self.assertEqual(found.feasible.tolist(), [False, True])
        self.assertEqual(np.isnan(found.tensions).all(axis=1).tolist(), [True, False])
        self.assertIs(found.tensions, out)
        self.assertTrue(np.isnan(self.model.tensions(outside[0]).tensions).all())
        # those have a meaning where the load is not balanced
        for method in ("closed-form", "nearest-wrench"):
            self.assertTrue(np.isfinite(self.model.tensions(outside, method).tensions).all())

    def test_stiffness_is_the_wrench_by_the_displacement(self) -> None:
        pose = self.poses[0]
        weight = -self.model.structure_matrix(pose) @ np.full(8, 4000.0)
        lengths = self.model.inverse(pose, [4000.0] * 8)
        stiffness = self.model.stiffness(pose, [4000.0] * 8, wrench=weight)
        for axis in range(3):
            step = np.zeros(6)
            step[axis] = 20.0
            sides = [self.model.forward(lengths, pose, wrench=weight + side * step).raise_for_status() for side in (1, -1)]
            moved = 0.5 * (sides[0].poses - sides[1].poses)
            # half of a small turn is the vector part of its quaternion, times the conjugate of the pose's; world axes
            turn = 2.0 * (pose[6] * moved[3:6] - moved[6] * pose[3:6] + np.cross(pose[3:6], moved[3:6]))
            # central differences: the rest is of third order in a displacement of 20 µm
            np.testing.assert_allclose(stiffness @ np.hstack([moved[:3], turn]), step, rtol=0, atol=1e-3 * 20.0)

    def test_problems_without_an_answer_say_why(self) -> None:
        lengths = np.full(8, 50.0)
        found = self.model.forward(lengths)
        self.assertFalse(found.converged.any())
        self.assertTrue(self.model.reason(lengths))
        with self.assertRaises(cdpr.Error):
            found.raise_for_status()


class Values(unittest.TestCase):
    def test_robots_models_and_samples_survive_pickling(self) -> None:
        robot = cdpr.Robot(HELICOPTER)
        samples = cdpr.Samples.from_arrays(poses=[[0.0, 0.0, 1.0]], lengths=[[1.0, 2.0, 3.0]], sigmas=cdpr.Sigmas(length=1e-3))
        for value in (robot, cdpr.Model(robot, "standard"), samples, cdpr.Study(__file__)):
            self.assertEqual(pickle.loads(pickle.dumps(value)), value)
            self.assertEqual(copy.deepcopy(value), value)
            self.assertEqual(hash(copy.copy(value)), hash(value))
            with self.assertRaises(AttributeError):
                value.name = "other"

    def test_parameters_by_name(self) -> None:
        robot = cdpr.Robot(HELICOPTER)
        x = robot["frame-anchor[3].x"]
        self.assertEqual((x.value, x.unit), (robot.frame_anchors[2, 0], "m"))
        other = robot.replace({"frame-anchor[3].x": 5.5})
        self.assertEqual(other.frame_anchors[2, 0], 5.5)
        self.assertEqual(robot["frame-anchor[3].x"], x)
        self.assertEqual(cdpr.Robot.from_toml(other.to_toml()), other)
        with self.assertRaises(KeyError):
            robot["frame-anchor"]
        for wrong in ({"no-such-number": 1.0}, {"frame-anchor[3].x": np.nan}):
            with self.assertRaises(cdpr.Error):
                robot.replace(wrong)

    def test_scipy_rotations_in_and_out(self) -> None:
        from scipy.spatial.transform import Rotation

        rows = angles(50)
        rotations = Rotation.from_euler("XYZ", rows[:, 3:])
        poses = cdpr.poses_of(rows[:, :3], rotations)
        model = cdpr.Model(HELICOPTER)
        np.testing.assert_allclose(model.inverse(poses), model.inverse(rows), rtol=0, atol=1e-13)
        np.testing.assert_allclose((cdpr.rotations_of(poses) * rotations.inv()).magnitude(), 0.0, atol=1e-12)

    def test_difference_of_two_models(self) -> None:
        rigid, elastic = cdpr.Model(ELASTIC, "standard"), cdpr.Model(ELASTIC, "elastic")
        poses = angles(20)
        same = cdpr.difference(elastic, elastic, poses)
        self.assertLess(np.nanmax(same.position), 1e-8)
        apart = cdpr.difference(rigid, elastic, poses)
        self.assertGreater(np.nanmax(apart.position), 1e-3)
        self.assertTrue((apart.lengths[np.isfinite(apart.lengths)] < 0).all())

    def test_states_are_snapshots(self) -> None:
        model = cdpr.Model("planar-example")
        state = cdpr.State(model)
        before = state.copy()
        rows = np.linspace([0.0, 5.0, 0.0][: model.robot.dof], [0.5, 4.0, 0.0][: model.robot.dof], 6)
        found = model.forward(model.inverse(rows), state=state).raise_for_status()
        np.testing.assert_allclose(model.robot.components(state.pose), rows[-1], atol=1e-9)
        np.testing.assert_allclose(model.robot.components(found.poses), rows, atol=1e-9)
        np.testing.assert_array_equal(before.pose, model.robot.home)

    def test_planar_robots_take_their_own_components(self) -> None:
        model = cdpr.Model("planar-example")
        rows = np.array([[0.5, 4.0, 0.0], [0.0, 5.0, 0.0]])[:, : model.robot.dof]
        lengths = model.inverse(rows)
        found = model.forward(lengths).raise_for_status()
        np.testing.assert_allclose(model.robot.components(found.poses), rows, atol=1e-9)


if __name__ == "__main__":
    unittest.main()
