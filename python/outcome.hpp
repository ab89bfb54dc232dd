#pragma once

#include <functional>
#include <string>

#include "frf/set/frf_set.hpp"
#include "ident/result/control.hpp"

namespace jointid::python {

/// What a command found. Texts are made when somebody asks for them, by functions that own all that they use; one that is empty
/// is not to be had of this command.
struct Outcome {
  std::string status;   ///< as in the JSON; empty where the command has none
  std::string message;  ///< why, and what helps; empty when all is well
  bool usable = true;   ///< whether the numbers may be used: the command's exit code 0
  std::function<std::string()> json{}, text{}, csv{};
  std::function<std::string(const ident::Control&)> page{};  ///< may have to read and compute
  std::function<frf::FrfSet(const ident::Control&)> frfs{};  ///< those that were made or predicted, receptances
};

}  // namespace jointid::python
