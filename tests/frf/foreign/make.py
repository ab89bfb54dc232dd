"""Writes the files of this folder as other programs do: numpy, h5py, scipy.io.savemat.

FRF of response r and reference c on line l: (1 + l) + 0.1 r + 0.01 c + i (r - 2 c - 0.5 l), lines 10, 20, 30, 40 Hz, responses 1:+Z 2:+Z,
references 1:+Z 2:+Z 3:-X. Where a unit stands beside them they are accelerances, in g/N where that is the unit.
"""
import os
import sys
import zipfile

import h5py
import numpy as np
import scipy.io

os.chdir(os.path.dirname(os.path.abspath(__file__)))
l, r, c = np.ogrid[0:4, 0:2, 0:3]
H = (1 + l) + 0.1 * r + 0.01 * c + 1j * (r - 2 * c - 0.5 * l)
f = np.array([10.0, 20.0, 30.0, 40.0])
responses, references = np.array(["1:+Z", "2:+Z"]), np.array(["1:+Z", "2:+Z", "3:-X"])
dofs = dict(response_dof=responses, reference_dof=references)

np.savez("stored.npz", frf=H, frequency=f, quantity="receptance", **dofs)
np.savez_compressed("packed.npz", H=np.asfortranarray(H.astype(">c8")), freq=f.astype(">f4"), unit="g/N",
                    response_dof=responses.astype("S"), reference_dof=references)
np.savez("square.npz", frf=H[:, :, :2], f=f.astype("i4"), quantity="receptance", dofs=responses)
np.savez("real.npz", frf=abs(H), frequency=f, quantity="receptance", **dofs)
np.savez("flat.npz", frf=H.reshape(4, 6), frequency=f, quantity="receptance", **dofs)
with open("stored.npz", "rb") as stored, open("twice.npz", "wb") as twice:
    twice.write(stored.read())
with zipfile.ZipFile("twice.npz", "a") as twice, twice.open("frequency.npy", "w") as member:
    np.save(member, 1000.0 * f)
np.save("frf.npy", H)
np.save("frequency.npy", f)

# As SDynPy saves functions: records with the coordinates of response and reference, codes of UFF 58.
coordinate = np.dtype([("node", "u8"), ("direction", "i1")])
functions = np.zeros((2, 3), np.dtype([("abscissa", "f8", (4,)), ("ordinate", "c16", (4,)), ("comment1", "U80"),
                                       ("coordinate", coordinate, (2,))]))
functions["abscissa"], functions["ordinate"] = f, np.moveaxis(H, 0, -1)
functions["coordinate"]["node"] = np.stack(np.broadcast_arrays([[1], [2]], [[1, 2, 3]]), -1)
functions["coordinate"]["direction"] = np.stack(np.broadcast_arrays([[3], [3]], [[3, 3, -1]]), -1)
np.savez("functions.npz", data=functions, function_type=4)
np.savez("coherences.npz", data=functions, function_type=6)
np.save("functions.npy", functions)
other = functions.copy()
other["coordinate"]["node"][1] = other["coordinate"]["node"][0]
np.save("functions_twice.npy", other)
other = functions.copy()
other["abscissa"][1, 2, 3] = 41.0
np.save("functions_lines.npy", other)
np.save("records.npy", np.zeros(3, np.dtype([("t", "f8"), ("a", "f8")])))


def with_h5(name, fill):
    with h5py.File(name, "w") as file:
        file["frequency"] = f
        fill(file)


def scaled(file):
    file["frf"] = H[:, :, :2]
    file["frf"].attrs["scale_factor"] = 0.001


def h5py_complex(file):
    file["frf"] = H[:, :, :2]
    file["frf"].attrs["Units"] = "g/N"


def parts(file):
    group = file.create_group("measured")
    group["H_real"], group["H_imag"] = H.real, H.imag
    file["frequency"][...] = 2 * np.pi * f
    file["frequency"].attrs["unit"] = "rad/s"


with_h5("h5py.h5", h5py_complex)
with_h5("parts.h5", parts)
with_h5("scaled.h5", scaled)


def quantity(label):
    return {"label": label, "unit_transformation": {"factor": 9.80665, "offset": 0.0}}


scipy.io.savemat("testlab.mat", {"FRF": {
    "x_values": {"start_value": 0.01, "increment": 0.01, "number_of_values": 4.0, "quantity": {"label": "kHz"}},
    "y_values": {"values": H[:, :1, :1].reshape(4, 1), "quantity": quantity("g/N")},
    "function_record": {"name": "x", "type": "FRF"}}})
dtype = [("f", object), ("H1", object), ("coh", object), ("refNode", object), ("refDir", object)]
run = np.empty((1, 3), dtype=dtype)
for k, (node, direction) in enumerate([(1, "+Z"), (2, "+Z"), (3, "-X")]):
    run[0, k] = (f, H[:, :, k], np.full((4, 2), 0.9 - 0.1 * k), float(node), direction)
scipy.io.savemat("runs.mat", {"run": run}, do_compression=True)
each = np.empty((6, 1), dtype=[("x", object), ("data", object), ("rsp_node", object), ("rsp_dir", object), ("ref_node", object), ("ref_dir", object)])
for k in range(6):
    i, j = k // 3, k % 3
    each[k, 0] = (f, H[:, i, j], float(i + 1), 3.0, float(j + 1), -1.0 if j == 2 else 3.0)
scipy.io.savemat("each.mat", {"sets": each})
scipy.io.savemat("cells.mat", {"test": {"freq": f, "FRF": H, "unit": "(m/s^2)/N", "resp": responses.astype(object),
                                        "ref": references.astype(object), "Coh": np.full(H.shape, 0.5), "navg": 5}})


def with_axes(file, name, order, labels, scales):
    """A group whose H has its axes in this order of F, R and C, named by labels, or by the variables along them."""
    group = file.create_group(name)
    group["H"] = np.transpose(H[:, :, :2], ["FRC".index(letter) for letter in order])
    axes = {"F": "band", "R": "out_dof", "C": "in_dof"} if scales else {"F": "frequency", "R": "response_dof", "C": "reference_dof"}
    group[axes["F"]] = 2 * np.pi * f if scales else f
    if scales:
        group[axes["F"]].attrs["units"] = "rad/s"
    texts = h5py.string_dtype()
    group[axes["R"]], group[axes["C"]] = np.array(responses, dtype=texts), np.array(references[:2], dtype=texts)
    for place, letter in enumerate(order):
        if scales:
            group[axes[letter]].make_scale(axes[letter])
            group["H"].dims[place].attach_scale(group[axes[letter]])
        else:
            group["H"].dims[place].label = labels[letter]


with h5py.File("axes.h5", "w", libver="latest") as file:
    for order in ("FCR", "RFC", "CRF"):
        with_axes(file, order, order, {}, True)
        with_axes(file, "named_" + order, order, {"F": "frequency", "R": "response_dof", "C": "reference_dof"}, False)
    with_axes(file, "German", "FCR", {"F": "Frequenz", "R": "Antwort", "C": "Anregung"}, False)
    with_axes(file, "unknown", "FCR", {"F": "dim_0", "R": "dim_1", "C": "dim_2"}, False)

np.savez("letters.npz", frf=H[:, :1, :1], frequency=f, unit="m·s⁻²·N⁻¹", response_dof=responses[:1], reference_dof=references[:1])
scipy.io.savemat("letters.mat", {"frf": H[:, :1, :1], "frequency": f, "unit": "µm/N", "response_dof": responses[:1].astype(object),
                                 "reference_dof": references[:1].astype(object)})

# Cells of arrays, of MATLAB v5 and v7.3, and structs in cells of v7.3; variables of GNU Octave in HDF5.
table = np.empty((2, 3), dtype=object)
for i, j in np.ndindex(table.shape):
    table[i, j] = H[:, i, j]
scipy.io.savemat("table.mat", {"H": table, "f": f, "unit": "g/N"})


def written(group, name, values, matlab_class):
    group[name] = values
    group[name].attrs["MATLAB_class"] = np.bytes_(matlab_class)


def numbers(group, name, values):
    parts_of = np.zeros(values.shape, [("real", "f8"), ("imag", "f8")])
    parts_of["real"], parts_of["imag"] = values.real, values.imag
    written(group, name, (parts_of if np.iscomplexobj(values) else values)[None, :], "double")


def characters(group, name, text):
    written(group, name, np.array([[ord(letter)] for letter in text], np.uint16), "char")


def as_matlab(name, fill):
    with h5py.File(name, "w", userblock_size=512) as file:
        numbers(file, "f", f)
        characters(file, "unit", "g/N")
        fill(file, file.create_group("#refs#"))
    with open(name, "r+b") as file:
        file.write("MATLAB 7.3 MAT-file, HDF5 schema 1.00 .".ljust(124).encode() + b"\x00\x02IM")


def cells(file, names, shape):
    written(file, "H", np.array([file[f"#refs#/{name}"].ref for name in names], dtype=h5py.ref_dtype).reshape(shape), "cell")


def cells_of_arrays(file, kept):
    for i, j in np.ndindex(table.shape):
        numbers(kept, f"a{i}{j}", H[:, i, j])
    cells(file, [f"a{i}{j}" for j in range(3) for i in range(2)], (3, 2))


def cells_of_structs(file, kept):
    for i in range(2):
        element = kept.create_group(f"s{i}")
        element.attrs["MATLAB_class"] = np.bytes_("struct")
        numbers(element, "f", f)
        numbers(element, "y", H[:, i, 0])
    cells(file, ["s0", "s1"], (1, 2))


as_matlab("table_v73.mat", cells_of_arrays)
as_matlab("structs_v73.mat", cells_of_structs)

with h5py.File("octave.h5", "w") as file:
    for name, kind, values in (("H", "complex matrix", H[:, :, :2].T), ("f", "matrix", f[None, :]), ("unit", "string", np.frombuffer(b"g/N", "i1")[:, None])):
        variable = file.create_group(name)
        variable.attrs["OCTAVE_NEW_FORMAT"] = np.uint8(1)
        variable["type"] = np.bytes_(kind)
        if np.iscomplexobj(values):
            pairs = np.zeros(values.shape, [("real", "f8"), ("imag", "f8")])
            pairs["real"], pairs["imag"] = values.real, values.imag
            values = pairs
        variable["value"] = values
