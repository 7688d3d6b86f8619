# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Runs the `esm` program in a folder of its own, as scripts do. The environment's ESM names the program."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["ESM"]
SOURCE = pathlib.Path(os.environ["ESM_SOURCE_DIR"])

# A tetrahedron with a fifth node inside that two struts hold.
TETRAHEDRON = """v 0 0 0
v 10 0 0
v 0 10 0
v 0 0 10
v 3 3 3
f 1 3 2
f 1 2 4
f 2 3 4
f 1 4 3
l 1 5
l 2 5
"""

# One kilogram on a spring of 100 N/m, pulled 0.1 m out of its rest: 10 rad/s, closed form 1 + 0.1 cos(10 t).
OSCILLATOR = {
    "format": "esm-net-1", "name": "oscillator", "duration": 1.0, "frame_rate": 50.0, "gravity": [0, 0, 0],
    "nodes": {"position": [0, 0, 0, 1.1, 0, 0], "mass": 1.0, "fixed": [0]},
    "springs": {"i": [0], "j": [1], "stiffness": 100.0, "viscosity": 0.0, "rest_length": 1.0, "law": "linear",
                "law_parameter": 0.0},
    "anchors": {"node": [], "point": [], "stiffness": [], "viscosity": []}, "forces": [], "motions": [],
}


class ProgramTest(unittest.TestCase):
    """A test in a new folder with tet.obj and osc.json in it."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="esm_cli_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.write("tet.obj", TETRAHEDRON)
        self.write("osc.json", json.dumps(OSCILLATOR))

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def read_json(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def run_anyhow(self, *arguments, environment=None):
        """Runs it, whatever comes of it. Returns the finished process."""
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
                              timeout=120, env={**os.environ, **(environment or {})}, check=False)

    def run_program(self, *arguments, exit_code=0, environment=None):
        """Runs it and checks the exit code. Returns the finished process."""
        done = self.run_anyhow(*arguments, environment=environment)
        self.assertEqual(done.returncode, exit_code, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def json_of(self, *arguments, exit_code=0, environment=None):
        """The object in the last line of stdout of a command with --json."""
        done = self.run_program(*arguments, "--json", exit_code=exit_code, environment=environment)
        return json.loads(done.stdout.splitlines()[-1])

    def refused(self, *arguments, exit_code=1):
        """The one line that says why the program refused."""
        done = self.run_program(*arguments, exit_code=exit_code)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr)
        if "--json" in map(str, arguments):
            self.assertEqual(json.loads(done.stdout)["exit_code"], exit_code)
        else:
            self.assertEqual(done.stdout, "")
        return lines[0]
