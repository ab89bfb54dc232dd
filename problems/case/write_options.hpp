#pragma once

#include <cstdint>
#include <string>

namespace jointid::problems {

/// How the files of a problem are written.
struct WriteOptions {
  std::string format = "h5";  ///< "h5" or "uff"
  std::uint64_t seed = 1;     ///< of the noise that the case is defined with
  std::string method = {};    ///< [identify] method of the scene; empty: that of the problem
  bool clean = false;         ///< leave the noise out
};

}  // namespace jointid::problems
