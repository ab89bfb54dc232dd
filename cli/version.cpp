#include "cli/version.hpp"

namespace jointid::cli {

std::string version_text() {
#ifdef JOINTID_HAS_MATIO
  const std::string matio = "yes";
#else
  const std::string matio = "no, this build lacks matio";
#endif
  return "jointid " JOINTID_VERSION
         "\nUFF 58/2414 and HDF5 files: yes"
         "\nMATLAB v5/v7 files: " +
         matio;
}

}  // namespace jointid::cli
