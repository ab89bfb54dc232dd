#pragma once

#include <optional>
#include <string>

namespace jointid::ident {

/// A joint that was held against its nominal stiffness: K = (1 − loss)·K_nominal.
struct LooseJoint {
  std::string joint;  ///< its name; empty where there is one
  double lost = 0.0;  ///< share of the nominal stiffness that is not there; negative: stiffer
  std::optional<double> std_error{};  ///< of it; empty where the method has none
  double probability = 0.0;           ///< that the joint is loose, 0 to 1
  std::optional<double> loss_factor{};  ///< D = η K, where it is an unknown
};

}  // namespace jointid::ident
