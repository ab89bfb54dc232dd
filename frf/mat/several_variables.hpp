#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"

namespace jointid::frf {

/// The error of a file of named arrays in which several variables may be the FRFs (MATLAB, HDF5, Octave, npz). Whoever asks can choose
/// one of them: OpenOptions::variable.
class SeveralVariables : public InputError {
 public:
  SeveralVariables(Parts parts, std::vector<std::string> names) : InputError(std::move(parts)), names_(std::move(names)) {}

  /// Each once, in the order of the file; of arrays of structs without the number of the element.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

}  // namespace jointid::frf
