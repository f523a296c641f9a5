"""pelt.motions: both layouts of AMASS, and hostile files."""

import io
import pathlib
import struct
import tempfile
import unittest
import unittest.mock
import zipfile

import numpy as np

import generated_body
import pelt
from pelt import motions
from support import Case


class Files(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "walk.npz"

    def saved(self, keys=None, **changes):
        return motions.load(generated_body.save_motion(self.path, keys, **changes))


class Layouts(Files):
    def test_smpl_h(self):
        motion = self.saved()
        self.assertEqual((len(motion), motion.fps, motion.gender), (6, 120.0, "male"))
        self.assertEqual((motion.poses.shape, motion.betas.shape), ((6, 156), (16,)))
        self.assertEqual(motion.seconds, 0.05)

    def test_smpl_x(self):
        parts = {"root_orient": 3, "pose_body": 63, "pose_jaw": 3, "pose_eye": 6, "pose_hand": 90}
        keys = {name: np.full((4, size), number) for number, (name, size) in enumerate(parts.items())}
        keys.update(trans=np.zeros((4, 3)), gender=np.array("neutral"), betas=np.zeros(16),
                    mocap_frame_rate=np.array(30), surface_model_type=np.array("smplx"))
        motion = self.saved(keys)
        self.assertEqual((motion.fps, motion.gender, motion.poses.shape), (30.0, "neutral", (4, 165)))
        self.assertEqual(motion.poses[0].tolist(),
                         [0] * 3 + [1] * 63 + [2] * 3 + [3] * 6 + [4] * 90)

    def test_inter_x(self):
        shapes = {"root_orient": (4, 3), "pose_body": (4, 21, 3), "pose_lhand": (4, 15, 3),
                  "pose_rhand": (4, 15, 3)}
        keys = {name: np.full(shape, number) for number, (name, shape) in enumerate(shapes.items())}
        keys.update(trans=np.zeros((4, 3)), gender=np.array("female"), betas=np.zeros((1, 10)))
        motion = motions.load(generated_body.save_motion(self.path, keys), fps=120)
        self.assertEqual((motion.fps, motion.gender, motion.betas.shape), (120, "female", (10,)))
        self.assertEqual(motion.poses[2].tolist(), [0] * 3 + [1] * 63 + [0] * 9 + [2] * 45 + [3] * 45)
        self.refuses("mocap_framerate: missing", self.saved, keys)
        self.refuses(r"pose_rhand: expected the shape \[4, 15, 3\], found \[3, 15, 3\]", self.saved, keys,
                     pose_rhand=np.zeros((3, 15, 3)))

    def test_rate_of_the_file_comes_first(self):
        path = generated_body.save_motion(self.path)
        self.assertEqual(motions.load(path, fps=30).fps, 120)

    def test_gender_in_other_types(self):
        self.assertEqual(self.saved(gender=np.array(b"female")).gender, "female")
        self.assertEqual(self.saved(gender=None).gender, "unknown")
        self.assertEqual(self.saved(gender=np.array("male", object)).gender, "unknown")

    def test_without_betas(self):
        self.assertEqual(self.saved(betas=None).betas.shape, (0,))

    def test_two_rates(self):
        self.assertEqual(self.saved(mocap_frame_rate=np.array(120)).fps, 120)
        rate = 119.88012
        rounded = self.saved(mocap_framerate=np.array(rate), mocap_frame_rate=np.float32(rate))
        self.assertEqual(rounded.fps, rate)
        self.refuses("walk.npz: mocap_framerate: is 120.0, but mocap_frame_rate is 60.0: state which of the "
                     "two is right by `--fps`, or fps=", self.saved, mocap_frame_rate=np.array(60.0))
        for fps in (60, 120):
            self.assertEqual(motions.load(self.path, fps=fps).fps, fps)
        self.refuses("is 120.0, but mocap_frame_rate is 60.0", motions.load, self.path, fps=30)
        self.refuses("walk.npz: mocap_frame_rate: expected more than 0", self.saved,
                     mocap_frame_rate=np.array(-1.0))

    def test_betas_of_a_batch_of_one(self):
        betas = np.arange(16.0)
        self.assertEqual(self.saved(betas=betas[np.newaxis]).betas.tolist(), betas.tolist())
        self.refuses(r"betas: expected the shape \[1, B\], found \[2, 8\]", self.saved,
                     betas=betas.reshape(2, 8))

    def test_slices(self):
        motion = self.saved()
        self.assertEqual((len(motion[::2]), motion[::2].fps), (3, 60.0))
        self.assertTrue(np.array_equal(motion[2:4].translations, motion.translations[2:4]))
        self.refuses("expected a step of 1 or more", lambda: motion[::-1])

    def test_body_only(self):
        motion = self.saved()
        body = motion.body_only(24)
        self.assertEqual(body.poses.shape, (6, 72))
        self.assertTrue(np.array_equal(body.poses[:, :66], motion.poses[:, :66]))
        self.assertFalse(body.poses[:, 66:].any())


class Refused(Files):
    def test_keys(self):
        infinite = np.zeros((6, 3))
        infinite[4, 2] = np.inf
        angles = generated_body.motion_keys()["poses"]
        angles[3, 9] = -1e308
        for message, changes in [
                ("walk.npz: poses: missing, and no root_orient", {"poses": None}),
                ("walk.npz: trans: missing", {"trans": None}),
                (r"walk.npz: trans: expected the shape \[6, 3\], found \[5, 3\]",
                 {"trans": np.zeros((5, 3))}),
                (r"walk.npz: trans: the element \[4, 2\] is not a finite number", {"trans": infinite}),
                (r"walk.npz: poses: the element \[3, 9\] is -1e\+308, expected within 2\^60: save the file",
                 {"poses": angles}),
                (r"walk.npz: trans: the element \[0, 0\] is 1e\+39, expected",
                 {"trans": np.full((6, 3), 1e39)}),
                (r"walk.npz: betas: the element \[0\] is not a finite number",
                 {"betas": np.full(16, np.nan)}),
                (r"walk.npz: betas: the element \[0\] is 1e\+300, expected", {"betas": np.full(16, 1e300)}),
                (r"walk.npz: poses: expected \[F, 3 J\]", {"poses": np.zeros((6, 100))}),
                (r"walk.npz: poses: expected \[F, 3 J\]", {"poses": np.zeros((0, 156)),
                                                          "trans": np.zeros((0, 3))}),
                ("walk.npz: poses: expected numbers, found <U1", {"poses": np.full((6, 156), "a")}),
                ("walk.npz: poses: holds pickled", {"poses": np.full((6, 156), None, object)}),
                ("walk.npz: poses: holds pickled", {"poses": np.full(2, None, object)}),
                ("walk.npz: mocap_framerate: missing, and no mocap_frame_rate",
                 {"mocap_framerate": None}),
                ("walk.npz: mocap_framerate: expected more than 0", {"mocap_framerate": np.array(0.0)}),
                (r"walk.npz: mocap_framerate: expected the shape \[1\]",
                 {"mocap_framerate": np.ones(2)})]:
            with self.subTest(message):
                self.refuses(message, self.saved, **changes)

    def test_pickle(self):
        self.refuses("walk.pkl: pickled files can run any code", motions.load, "walk.pkl")

    def test_no_file(self):
        self.refuses("nothing.npz: cannot be opened: No such file", motions.load, "nothing.npz")
        self.refuses(": cannot be opened: Is a directory", motions.load, self.path.parent)

    def test_truncated_at_any_length(self):
        generated_body.save_motion(self.path)
        whole = self.path.read_bytes()
        random = np.random.default_rng(5)
        for length in [0, 1, 4, 100, len(whole) - 1, *random.integers(0, len(whole), 60)]:
            self.path.write_bytes(whole[:length])
            self.refuses("walk.npz", motions.load, self.path)

    def test_random_changes_raise_or_load(self):
        generated_body.save_motion(self.path)
        whole = np.frombuffer(self.path.read_bytes(), np.uint8)
        refused = 0
        for seed in range(300):
            random = np.random.default_rng(seed)
            changed = whole.copy()
            # Headers are at the start of each array, and the directory is at the end.
            places = random.integers(0, 400, 3) if seed % 2 else len(whole) - random.integers(1, 600, 3)
            changed[places] = random.integers(0, 256, 3)
            self.path.write_bytes(changed.tobytes())
            try:
                motions.load(self.path)
            except pelt.Error as error:
                refused += 1
                self.assertIn("walk.npz", str(error), seed)
        self.assertGreater(refused, 100)

    def entry(self, name, header, data=b""):
        """Writes a file with one array of this header."""
        stream = io.BytesIO()
        np.lib.format.write_array_header_1_0(stream, header)
        with zipfile.ZipFile(self.path, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(name + ".npy", stream.getvalue() + data)

    def test_array_larger_than_its_entry(self):
        for shape in [(10**12, 156), (-1, 156), (10**30, 156)]:
            self.entry("poses", {"descr": "<f8", "fortran_order": False, "shape": shape})
            self.refuses("walk.npz: poses: ", motions.load, self.path)

    def test_headers_that_are_no_literals(self):
        for text in ["{'shape': (3", "(" * 9000, "(" * 4000 + ")" * 4000, "'''", "1_", "__import__('os')"]:
            header = text.encode().ljust(9000) + b"\n"
            with zipfile.ZipFile(self.path, "w") as archive:
                archive.writestr("poses.npy", b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header)
            with self.subTest(text[:20]):
                self.refuses("walk.npz: poses: not an array of NumPy", motions.load, self.path)

    def test_more_bytes_than_allowed(self):
        self.entry("poses", {"descr": "|i1", "fortran_order": False, "shape": (10, 156)}, bytes(1560))
        with unittest.mock.patch("pelt._npz._MAX_BYTES", 8 * 1560 - 1):
            self.refuses("walk.npz: poses: the arrays need more than", motions.load, self.path)
        generated_body.save_motion(self.path)
        with unittest.mock.patch("pelt._npz._MAX_BYTES", 4000):
            self.refuses("walk.npz: poses: the arrays need more than 4000 bytes", motions.load, self.path)
        self.entry("poses", {"descr": "<f8", "fortran_order": False, "shape": (10**6, 156)},
                   bytes(10**6))
        self.refuses("walk.npz: poses: is cut off: 1248000000 bytes expected, 1000128 stored",
                     motions.load, self.path)


if __name__ == "__main__":
    unittest.main()
