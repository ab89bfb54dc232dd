#include "cli/text/version.hpp"

#include "minimise/least_squares.hpp"

namespace jointid::cli {

std::string version_number() { return JOINTID_VERSION; }

std::string version_text() {
  const std::string matio = JOINTID_HAVE_MATIO ? "yes" : "no, this build lacks matio";
  const std::string mpi = JOINTID_HAVE_MPI ? "yes" : "no, this build lacks MPI";
  const std::string ceres = JOINTID_HAVE_CERES ? "yes" : "no, this build lacks Ceres";
  const std::string nlopt = minimise::has_nlopt() ? "yes" : "no, this build lacks NLopt";
  const std::string ipopt = minimise::has_ipopt() ? "yes" : "no, this build lacks Ipopt";
  return "jointid " + version_number() +
         "\nUFF 58 and 58b, HDF5, MATLAB v7.3 and CSV files: yes\nMATLAB v5 to v7 files: " + matio +
         "\nSolver ceres of methods likelihood and newton: " + ceres +
         "\nSolvers nlopt, nlopt-crs2 and nlopt-sbplx of method newton, global start of loading-curve: " + nlopt +
         "\nSolver ipopt of method newton: " + ipopt + "\nStudies under mpirun: " + mpi;
}

}  // namespace jointid::cli
