#!/usr/bin/env python3
"""Runs the recipes of docs/clusters.md, each with a worker that is killed.

    clusters_test.py COMMAND DOCUMENT parallel|slurm
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import one_node_slurm

TESTS = pathlib.Path(__file__).parent.parent
sys.path += [str(TESTS / "tools" / "shard"), str(TESTS / "support")]
import check_runs  # noqa: E402  pylint: disable=wrong-import-position
import unittest_program  # noqa: E402  pylint: disable=wrong-import-position

CLUSTER = sys.argv.pop()
DOCUMENT = pathlib.Path(sys.argv.pop()).read_text(encoding="utf-8")
COMMAND = sys.argv.pop()
FRAMES = '"count": 13, "fps": 8'

# Kills the first process that queries shard 2. Tries again if the process has ended before.
KILLING = """#!/bin/sh
case "$*" in
  *"--shard 2/"*)
    if [ ! -e killed ]; then
      for file; do :; done
      until [ -e killed ]; do
        rm -f "$file"
        "$PELT" "$@" &
        kill -9 $!
        wait $!
        [ $? = 137 ] && touch killed
      done
      exit 137
    fi ;;
esac
exec "$PELT" "$@"
"""


def recipe(name):
    return re.search(rf"<!-- recipe: {name} -->\n```sh\n(.*?)```", DOCUMENT, re.DOTALL)[1]


class Cluster(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "pelt").write_text(KILLING)
        (self.folder / "bin" / "pelt").chmod(0o755)
        (self.folder / "limb.glb").write_bytes(check_runs.limb())
        self.write_scene("scene.json", 0.7)
        self.environment = {**os.environ, "PELT": COMMAND, "HOME": folder.name,
                            "PATH": f"{folder.name}/bin:{os.environ['PATH']}"}
        subprocess.run([COMMAND, "check", "scene.json", "--pairs", "--jsonl", "expected.jsonl"],
                       cwd=self.folder, check=False, capture_output=True)

    def write_scene(self, name, distance, model="limb.glb"):
        text = check_runs.scene([("bend", 0, 0), ("bend", 0.3, distance)], FRAMES)
        (self.folder / name).write_text(text.replace("limb.glb", model))

    def sh(self, text, environment=None):
        return subprocess.run(["sh", "-c", text], cwd=self.folder, text=True, capture_output=True,
                              env=environment or self.environment, check=False)

    def require(self, program, package):
        if shutil.which(program) is None:
            self.skipTest(f"{program} is missing (apt-get install {package})")

    def expect_the_answer(self, ended):
        self.assertEqual(ended.returncode, 1, ended.stderr)  # the bodies touch
        self.assertEqual((self.folder / "contacts.jsonl").read_bytes(),
                         (self.folder / "expected.jsonl").read_bytes())

    def expect_a_lost_shard(self, ended):
        self.assertTrue((self.folder / "killed").exists(), ended.stderr)
        self.assertEqual(ended.returncode, 2)
        self.assertRegex(ended.stderr, "shard 2/[0-9]+ is missing")
        self.assertFalse((self.folder / "contacts.jsonl").exists())
        self.assertFalse((self.folder / "2.shard").exists())


class Parallel(Cluster):
    def test_gnu_parallel(self):
        self.require("parallel", "parallel")
        text = recipe("parallel")
        self.expect_a_lost_shard(self.sh(text))
        self.expect_the_answer(self.sh(text))
        calls = (self.folder / "shards.log").read_text().count("--shard")
        self.assertEqual(calls, 9, "only the killed shard is written again")

    def test_many_scenes(self):
        self.require("parallel", "parallel")
        (self.folder / "scenes").mkdir()
        for i in range(3):
            self.write_scene(f"scenes/{i}.json", 0.7 + 4 * i, "../limb.glb")
        self.assertEqual(self.sh(recipe("scenes")).returncode, 1)  # one scene has contacts
        self.assertEqual(len(list((self.folder / "answers").iterdir())), 3)

    def test_a_list_in_shards(self):
        self.require("parallel", "parallel")
        (self.folder / "scenes").mkdir()
        for i in range(7):
            self.write_scene(f"scenes/{i}.json", 0.7 + 4 * (i % 2), "../limb.glb")
        text = recipe("list")
        self.expect_a_lost_shard(self.sh(text))
        self.assertEqual(self.sh(text).returncode, 1)
        calls = (self.folder / "list.log").read_text().count("--shard")
        self.assertEqual(calls, 5, "only the killed shard is written again")
        self.sh("pelt check --scenes scenes.txt --jsonl expected.jsonl")
        self.assertEqual((self.folder / "answers.jsonl").read_bytes(),
                         (self.folder / "expected.jsonl").read_bytes())


class Slurm(Cluster):
    def test_slurm(self):
        reason = one_node_slurm.reason_to_skip()
        if reason:
            self.skipTest(reason)
        with tempfile.TemporaryDirectory() as scratch:
            cluster = one_node_slurm.Cluster(scratch)
            try:
                cluster.__enter__()
            except (RuntimeError, OSError) as error:
                self.skipTest(f"Slurm does not start here: {error}")
            try:
                environment = {**self.environment, "SLURM_CONF": f"{scratch}/slurm.conf"}
                self.expect_a_lost_shard(self.sh(recipe("slurm"), environment))
                self.expect_the_answer(self.sh(recipe("slurm"), environment))
            finally:
                cluster.__exit__()


if __name__ == "__main__":
    unittest_program.main([{"parallel": "Parallel", "slurm": "Slurm"}[CLUSTER]])
