#include "cli/text/version.hpp"

#include "dense/blas.hpp"
#include "frf/hdf5/hdf5_module.hpp"
#include "frf/mat/mat_module.hpp"
#include "ident/team/team.hpp"
#include "minimise/least_squares.hpp"
#include "minimise/linear/sparse_qr.hpp"
#include "models/sparse_factors.hpp"

namespace jointid::cli {
namespace {

std::string line(const std::string& what, bool is_there, const std::string& library) {
  return "\n" + what + ": " + (is_there ? "yes" : "no, this build lacks " + library);
}

}  // namespace

std::string version_number() { return JOINTID_VERSION; }

std::string version_text() {
  return "jointid " + version_number() + "\nUFF 58 and 58b, and CSV files: yes" +
         line("HDF5 and MATLAB v7.3 files, studies", frf::has_hdf5(), "HDF5") +
         line("MATLAB v5 to v7 files", frf::has_matio(), "matio") +
         line("Fast products for many joint coordinates", dense::has_blas(), "OpenBLAS") +
         line("Solver spqr of methods one, two and direct", minimise::has_spqr(), "SPQR") +
         line("Fast factors of models with many coordinates", models::has_cholmod(), "CHOLMOD") +
         line("Solver ceres of methods likelihood and newton", minimise::has_ceres(), "Ceres") +
         line("Solver ipopt of method newton", minimise::has_ipopt(), "Ipopt") +
         line("Studies under mpirun", ident::has_mpi(), "MPI");
}

}  // namespace jointid::cli
