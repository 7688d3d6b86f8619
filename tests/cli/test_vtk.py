#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""VTK's own reader on what `esm` writes. Its error code is 0 for broken files too: counts, arrays and the text of its
output window tell. Exit code 77 (skipped) without VTK."""
import sys
import unittest

try:
    import vtk
except ImportError:
    print("python3-vtk9 is not there")
    sys.exit(77)

from program import ProgramTest
from readers import read_pvd


class Log(vtk.vtkStringOutputWindow):
    """What VTK complains of goes here, not to a window."""


def read(path):
    log = Log()
    vtk.vtkOutputWindow.SetInstance(log)
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput(), log.GetOutput()


class Vtk(ProgramTest):
    def check(self, grid, complaints, nodes=5, springs=8, triangles=4):
        self.assertEqual(complaints, "")
        self.assertEqual((grid.GetNumberOfPoints(), grid.GetNumberOfCells()), (nodes, springs + triangles))
        kinds = [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())]
        self.assertEqual((kinds.count(vtk.VTK_LINE), kinds.count(vtk.VTK_TRIANGLE)), (springs, triangles))
        for name in ("stiffness", "damping", "rest_length", "strain", "force"):
            self.assertEqual(grid.GetCellData().GetArray(name).GetNumberOfTuples(), springs + triangles, name)
        for name, width in (("displacement", 3), ("velocity", 3), ("mass", 1), ("fixed", 1)):
            array = grid.GetPointData().GetArray(name)
            self.assertEqual((array.GetNumberOfTuples(), array.GetNumberOfComponents()), (nodes, width), name)

    def test_shape(self):
        self.run_program("import", "tet.obj", "-o", "p.esm", "--unit", "cm")
        self.run_program("export", "p.esm", "-o", "x.vtu")
        grid, complaints = read(self.folder / "x.vtu")
        self.check(grid, complaints)
        project = self.read_json("p.esm")
        flat = [x for i in range(5) for x in grid.GetPoint(i)]
        self.assertEqual(flat, project["geometry"]["position"])
        stiffness = grid.GetCellData().GetArray("stiffness")
        self.assertEqual([stiffness.GetValue(i) for i in range(8)], project["net"]["springs"]["stiffness"])
        ends = [grid.GetCell(i).GetPointId(k) for i in range(8) for k in (0, 1)]
        self.assertEqual(ends, project["net"]["springs"]["ends"])

    def test_motion_begins_with_frame_0_and_tells_real_times(self):
        self.run_program("import", "tet.obj", "-o", "p.esm", "--unit", "cm")
        self.run_program("apply", "p.esm", "-o", "p.esm", "--gravity", "0,0,-9.81")
        self.run_program("simulate", "p.esm", "--duration", "0.1", "--frames", "20", "-o", "m.pvd")
        frames = read_pvd(self.folder / "m.pvd")
        times = [time for time, _ in frames]
        self.assertEqual(times, sorted(set(times)))
        self.assertEqual((len(times), times[0]), (3, 0))
        for time, path in frames:
            grid, complaints = read(path)
            self.check(grid, complaints)
            self.assertEqual(grid.GetFieldData().GetArray("TimeValue").GetValue(0), time)

    def test_the_check_sees_broken_files(self):
        self.run_program("import", "tet.obj", "-o", "p.esm", "--unit", "cm")
        self.run_program("export", "p.esm", "-o", "x.vtu")
        content = (self.folder / "x.vtu").read_bytes()
        for broken in (content.replace(b'Name="connectivity"', b'Name="connections_"'), content[:len(content) // 2],
                       content.replace(b'NumberOfPoints="5"', b'NumberOfPoints="9"')):
            self.assertNotEqual(broken, content)
            self.write("y.vtu", broken)
            with self.assertRaises(AssertionError):
                self.check(*read(self.folder / "y.vtu"))


if __name__ == "__main__":
    unittest.main()
