# Not tested by the authors: put it into a Spack repository as packages/jointid/package.py
from spack.package import *


class Jointid(CMakePackage):
    """Identifies the joints of structures from measured frequency response functions, with intervals."""

    license("BSD-3-Clause")

    version("0.2.0", tag="v0.2.0")

    variant("mpi", default=False, description="Studies shared among the processes of mpirun")
    variant("solvers", default=True, description="SPQR, CHOLMOD, Ceres, Ipopt and products by OpenBLAS")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("eigen@3.4:")
    depends_on("hdf5@1.10:")
    depends_on("matio")
    depends_on("zlib-api")
    depends_on("tomlplusplus")
    depends_on("nlohmann-json")
    depends_on("cli11")
    depends_on("fmt@9:")
    depends_on("intel-tbb")
    depends_on("random123")
    depends_on("boost")
    depends_on("mpi", when="+mpi")
    depends_on("suite-sparse", when="+solvers")
    depends_on("ceres-solver", when="+solvers")
    depends_on("ipopt", when="+solvers")
    depends_on("openblas", when="+solvers")

    def cmake_args(self):
        solvers = [self.define_from_variant(f"JOINTID_WITH_{name}", "solvers") for name in ("SPQR", "CERES", "IPOPT", "OPENBLAS")]
        return [self.define("JOINTID_BUILD_TESTS", False), self.define("JOINTID_BUILD_GUI", False),
                self.define("JOINTID_PYTHON", False), self.define("CMAKE_UNITY_BUILD", True),
                self.define_from_variant("JOINTID_WITH_MPI", "mpi"), *solvers]
