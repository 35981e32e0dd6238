"""Reads bed.vtp, contacts.vtp and bed.xyz of small_bed() with VTK and ASE. Exit code 77: neither is installed."""
import sys

folder = sys.argv[1]
checked = 0
try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    pass
else:
    def read(name):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(f"{folder}/{name}")
        reader.Update()
        return reader.GetOutput()

    bed = read("bed.vtp")
    assert (bed.GetNumberOfPoints(), bed.GetNumberOfVerts()) == (3, 3)
    arrays = {name: vtk_to_numpy(bed.GetPointData().GetArray(name)).tolist() for name in ("radius", "velocity", "cluster", "contacts")}
    assert arrays["radius"] == [0.005] * 3 and arrays["velocity"][1] == [0.1, -0.2, 1 / 3], arrays
    assert arrays["cluster"] == [0, 1, 1] and arrays["contacts"] == [2, 1, 0], arrays
    contacts = read("contacts.vtp")
    assert contacts.GetNumberOfLines() == 2
    assert vtk_to_numpy(contacts.GetCellData().GetArray("normal_force")).tolist() == [2.5, 4.0]
    checked += 1
try:
    import ase.io
except ImportError:
    pass
else:
    atoms = ase.io.read(f"{folder}/bed.xyz")
    assert atoms.positions.tolist()[1] == [0.01, 0.01, 0.0149] and atoms.arrays["radius"].tolist() == [0.005] * 3
    assert atoms.arrays["cluster"].tolist() == [0, 1, 1] and atoms.cell.diagonal().tolist() == [0.03, 0.02, 0.025]
    checked += 1
print(f"{checked} programs read the files")
sys.exit(0 if checked else 77)
