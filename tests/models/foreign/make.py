"""Writes the matrices of this folder as scipy and numpy do. K is [[2, -1, 0, 5], [-1, 3, 0, 0], [0, 0, 4, 0.5], [5, 0, 0.5, 6]]."""
import os

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
