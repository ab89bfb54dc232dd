#include "cli/version.hpp"

namespace jointid::cli {

std::string version_number() { return JOINTID_VERSION; }

std::string version_text() {
#ifdef JOINTID_HAS_MATIO
  const std::string matio = "yes";
#else
  const std::string matio = "no, this build lacks matio";
#endif
  const std::string mpi = JOINTID_HAVE_MPI ? "yes" : "no, this build lacks MPI";
  return "jointid " JOINTID_VERSION
         "\nUFF 58/2414 and HDF5 files: yes"
         "\nMATLAB v5/v7 files: " +
         matio + "\nstudies under mpirun: " + mpi;
}

}  // namespace jointid::cli
