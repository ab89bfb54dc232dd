#include "cli/version.hpp"

#include "friction/least_squares.hpp"

namespace jointid::cli {

std::string version_number() { return JOINTID_VERSION; }

std::string version_text() {
  const std::string matio = JOINTID_HAVE_MATIO ? "yes" : "no, this build lacks matio";
  const std::string mpi = JOINTID_HAVE_MPI ? "yes" : "no, this build lacks MPI";
  const std::string ceres = JOINTID_HAVE_CERES ? "yes" : "no, this build lacks Ceres";
  const std::string nlopt = friction::has_nlopt() ? "yes" : "no, this build lacks NLopt";
  return "jointid " + version_number() + "\nUFF 58 and 58b, HDF5, MATLAB v7.3 and CSV files: yes\nMATLAB v5 to v7 files: " + matio +
         "\nSolver ceres of method likelihood: " + ceres + "\nStudies under mpirun: " + mpi +
         "\nGlobal start of loading-curve: " + nlopt;
}

}  // namespace jointid::cli
