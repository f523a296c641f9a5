"""pelt.body_models: the order of smplx.lbs, and refused files."""

import pathlib
import tempfile
import unittest

import numpy as np

import generated_body
import pelt
from pelt import body_models, motions
from support import Case


class Bodies(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def body(self, **changes):
        return body_models.load(generated_body.save_body(self.folder / "body.npz", **changes))

    def motion(self, **changes):
        return motions.load(generated_body.save_motion(self.folder / "walk.npz", **changes))

    def test_shapes(self):
        body = self.body()
        self.assertEqual(body.joint_count, 52)
        self.assertEqual(body.parents.tolist(), generated_body.PARENTS)
        self.assertTrue(body.subject().model.is_closed)
        self.assertIn("52 joints", repr(body))

    def test_vertices_are_those_of_the_reference(self):
        motion, keys = self.motion(), generated_body.arrays()
        positions = self.body().subject(motion.betas).poses(motion).positions
        self.assertEqual(positions.dtype, np.float32)
        for frame in range(len(motion)):
            expected = generated_body.reference_vertices(
                keys, motion.betas, motion.poses[frame], motion.translations[frame])
            self.assertLess(np.abs(positions[frame] - expected).max(), 2e-6)

    def test_palettes_pose_without_correctives(self):
        motion = self.motion()
        keys = {**generated_body.arrays(), "posedirs": np.zeros_like(generated_body.arrays()["posedirs"])}
        subject = self.body().subject(motion.betas)
        posed = pelt.posed_vertices(subject.model, subject.palettes(motion))
        for frame in range(len(motion)):
            expected = generated_body.reference_vertices(
                keys, motion.betas, motion.poses[frame], motion.translations[frame])
            self.assertLess(np.abs(posed[frame] - expected).max(), 2e-6)

    def test_chunks_are_the_whole(self):
        motion = self.motion()
        subject = self.body().subject(motion.betas)
        chunks = list(subject.chunks(motion, 4))
        self.assertEqual([first for first, _ in chunks], [0, 4])
        self.assertTrue(np.array_equal(np.concatenate([poses.positions for _, poses in chunks]),
                                       subject.poses(motion).positions))

    def test_a_frame_does_not_depend_on_others(self):
        keys = generated_body.motion_keys(frames=19)
        keys["poses"][5:16, 66:] = 0  # hands at rest
        keys["poses"][3] = 0
        motion = self.motion(**keys)
        subject = self.body().subject(motion.betas)
        whole = subject.poses(motion, threads=1).positions
        self.assertTrue(np.array_equal(subject.poses(motion, threads=2).positions, whole))
        for frame in range(19):
            alone = subject.poses(motion[frame:frame + 1]).positions[0]
            self.assertTrue(np.array_equal(alone, whole[frame]), frame)
            expected = generated_body.reference_vertices(
                generated_body.arrays(), motion.betas, motion.poses[frame], motion.translations[frame])
            self.assertLess(np.abs(alone - expected).max(), 2e-6)
        self.refuses("threads: expected 1", subject.poses, motion, threads=0)

    def test_joints_depend_on_the_shape(self):
        body = self.body()
        self.assertGreater(np.abs(body.subject([3]).joints - body.subject().joints).max(), 1e-5)
        self.refuses("betas: 17 shape parameters, but the body model has 16", body.subject, np.ones(17))
        self.refuses("betas: expected finite", body.subject, [np.nan])

    def test_motion_of_another_model(self):
        subject = self.body().subject()
        motion = self.motion(poses=np.zeros((6, 165)))
        self.refuses("poses of 55 joints, but the body model has 52", subject.poses, motion)
        self.assertEqual(len(subject.poses(motion.body_only(52))), 6)

    def test_self_contact(self):
        motion = self.motion()
        subject = self.body().subject(motion.betas)
        pairs = pelt.self_collide(subject.model, subject.poses(motion)).per_frame()
        self.assertEqual(pairs[0], 0)
        self.assertGreater(pairs[-1], 0)

    def test_refused_arrays(self):
        weights = generated_body.arrays()["weights"]
        nan = generated_body.arrays()["v_template"].copy()
        nan[5, 1] = np.nan
        table = generated_body.arrays()["kintree_table"].copy()
        table[0, 7] = 30
        faces = generated_body.arrays()["f"].copy()
        faces[3, 2] = 100_000
        path = self.folder / "body.npz"
        for message, changes in [
                ("body.npz: weights: missing", {"weights": None}),
                (r"body.npz: shapedirs: expected the shape \[\d+, 3, B\], found \[3\]",
                 {"shapedirs": np.zeros(3)}),
                (r"body.npz: posedirs: expected the shape \[\d+, 3, 459\], found \[\d+, 3, 207\]",
                 {"posedirs": np.zeros((len(weights), 3, 207))}),
                (r"body.npz: v_template: the element \[5, 1\] is not a finite number",
                 {"v_template": nan}),
                ("body.npz: J_regressor: holds pickled Python objects",
                 {"J_regressor": np.full((52, len(weights)), None, object)}),
                ("body.npz: kintree_table: joint 7 has the parent 30", {"kintree_table": table}),
                ("body.npz: f: expected vertices from 0", {"f": faces}),
                ("body.npz: f: there are no triangles", {"f": faces[:0]}),
                ("body.npz: f: expected integers, found float64", {"f": faces.astype(float)})]:
            with self.subTest(message):
                generated_body.save_body(path, **changes)
                self.refuses(message, body_models.load, path)

    def test_refused_numbers(self):
        """All become float32, where they would overflow."""
        path = self.folder / "body.npz"
        for key in ("v_template", "shapedirs", "posedirs", "J_regressor", "weights"):
            for value, message in [(1e308, r"1e\+308, expected within 2\^60"), (-1e39, r"-1e\+39, expected"),
                                   (2.0**61, r"2.30584e\+18, expected"), (np.nan, "not a finite number"),
                                   (-np.inf, "not a finite number")]:
                with self.subTest(key=key, value=value):
                    values = generated_body.arrays()[key].copy()
                    values[1, 1] = value
                    generated_body.save_body(path, **{key: values})
                    self.refuses(rf"body.npz: {key}: the element \[1, 1.*\] is {message}.*: save the file",
                                 body_models.load, path)

    def test_refused_weights(self):
        path = self.folder / "body.npz"
        for row in (-0.5, 0, 1e-60):
            weights = generated_body.arrays()["weights"].copy()
            weights[7] = row
            generated_body.save_body(path, weights=weights)
            self.refuses("body.npz: weights: vertex 7 has a weight less than 0, or none greater than 0: save",
                         body_models.load, path)

    def test_shapes_that_overflow(self):
        body = self.body()
        for betas in ([1e300], [1e308, -1e308], [1e25]):
            self.refuses("betas: vertex 0 of this shape is at .*, expected within 2.60: use smaller",
                         body.subject, betas)
        self.assertLess(0, len(body.subject([1e3]).rest))

    def test_pickle_is_refused_with_the_conversion(self):
        self.refuses(r"(?s)SMPL_MALE.pkl: pickled files can run any code.*numpy.savez\('SMPL_MALE.npz'",
                     body_models.load, "SMPL_MALE.pkl")


if __name__ == "__main__":
    unittest.main()
