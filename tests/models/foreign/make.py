"""Writes the matrices of this folder as scipy and numpy do. K is [[2, -1, 0, 5], [-1, 3, 0, 0], [0, 0, 4, 0.5], [5, 0, 0.5, 6]]."""
import os

import h5py
import numpy as np
import scipy.io
import scipy.sparse as sp

os.chdir(os.path.dirname(os.path.abspath(__file__)))
K = np.array([[2.0, -1.0, 0.0, 5.0], [-1.0, 3.0, 0.0, 0.0], [0.0, 0.0, 4.0, 0.5], [5.0, 0.0, 0.5, 6.0]])
lossy = K * (1 + 0.02j)

scipy.io.savemat("sparse_v5.mat", {"K": sp.csc_matrix(K), "D": sp.csc_matrix(lossy), "model": {"M": sp.csc_matrix(2.0 * K)}, "full": lossy,
                                   "wide": sp.csc_matrix(K[:2]), "flags": sp.csc_matrix(K != 0.0), "frequency": [[1.0, 2.0, 3.0]]})
scipy.io.savemat("packed_v5.mat", {"K": sp.csc_matrix(K)}, do_compression=True)
scipy.io.savemat("sparse_v4.mat", {"K": sp.csc_matrix(K), "D": sp.csc_matrix(lossy), "wide": sp.csc_matrix(K[:2])}, format="4")
for kind in ("csc", "csr", "coo", "bsr", "dia"):
    sp.save_npz(f"{kind}.npz", sp.coo_matrix(K).asformat(kind), compressed=kind == "csr")
twice = sp.coo_matrix(([*sp.coo_matrix(K).data, 1.0, -1.0], ([*sp.coo_matrix(K).row, 0, 0], [*sp.coo_matrix(K).col, 0, 0])), K.shape)
sp.save_npz("twice.npz", twice, compressed=False)
np.save("K.npy", K)
np.savez("model.npz", K=K, M=2.0 * K, lossy=lossy, frequency=np.arange(3.0), dofs=np.array(["4:+Y", "5:+Y", "6:+Y", "7:+Y"]))
P = K + 4.0 * np.eye(4)  # of a structure: K is indefinite
np.savez("part.npz", M=2.0 * P, lossy=(1.0 + 0.02j) * P, dofs=np.array(["4:+Y", "5:+Y", "6:+Y", "7:+Y"]))


def class_of(thing, name):
    thing.attrs["MATLAB_class"] = np.bytes_(name)


def sparse_group(file, name, matrix, kind="double"):
    matrix = sp.csc_matrix(matrix)
    group = file.create_group(name)
    group.attrs["MATLAB_sparse"] = np.uint64(matrix.shape[0])
    class_of(group, kind)
    if kind == "logical":
        group.attrs["MATLAB_int_decode"] = np.int32(1)
    if matrix.nnz:
        data = matrix.data.astype(np.uint8) if kind == "logical" else matrix.data
        if np.iscomplexobj(data):
            data = np.array(list(zip(data.real, data.imag)), dtype=[("real", "<f8"), ("imag", "<f8")])
        group["data"] = data
        group["ir"] = matrix.indices.astype(np.uint64)
    group["jc"] = matrix.indptr.astype(np.uint64)


# As MATLAB does with -v7.3: a user block with its name, sparse matrices as groups.
with h5py.File("sparse_v73.mat", "w", userblock_size=512) as file:
    sparse_group(file, "K", K)
    sparse_group(file, "D", lossy)
    sparse_group(file, "flags", K != 0.0, "logical")
    sparse_group(file, "wide", np.eye(2, 4))  # columns beyond the rows are empty: square as far as the elements tell
    sparse_group(file, "tall", np.eye(4, 2))
    sparse_group(file, "zero", np.zeros((4, 4)))
    sparse_group(file, "cut", K)
    del file["cut/ir"]
    class_of(file.create_group("model"), "struct")
    sparse_group(file["model"], "M", 2.0 * K)
    file["full"] = K.T
    class_of(file["full"], "double")
    file["none"] = np.zeros(2, np.uint64)
    class_of(file["none"], "double")
    file["none"].attrs["MATLAB_empty"] = np.uint8(1)
with open("sparse_v73.mat", "r+b") as file:
    file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Tue Dec  1 00:00:00 2026 HDF5 schema 1.00 .".ljust(124) + b"\0\2IM")
