#include "cli/version.hpp"

namespace jointid::cli {

std::string version_text() {
  const std::string matio = JOINTID_HAVE_MATIO ? "yes" : "no, this build lacks matio";
  return "jointid " JOINTID_VERSION
         "\nUFF 58 and 58b, HDF5, MATLAB v7.3 and CSV files: yes"
         "\nMATLAB v5 to v7 files: " +
         matio;
}

}  // namespace jointid::cli
