#pragma once

#include <vector>

#include "response/harmonic/excitation.hpp"
#include "response/structure/receptance.hpp"

namespace jointid::response {

/// What the equations need of the structure at one frequency, for each harmonic n: parts of H(nω), times the forces P_n.
struct HarmonicLine {
  struct One {
    Eigen::MatrixXcd joints;     ///< G_n = WᵀHW, [joint, joint]
    Eigen::VectorXcd driven;     ///< b_n = WᵀHP_n, [joint]
    Eigen::MatrixXcd to_joints;  ///< HW at the responses, [response, joint]
    Eigen::VectorXcd free;       ///< HP_n at the responses
  };
  double omega = 0.0;
  std::vector<One> harmonics;
  std::vector<One> slopes;  ///< the same by ω: n H′(nω); empty unless asked for
};

/// Throws InputError where H(nω) is not known, or its derivative where it is asked for.
HarmonicLine harmonic_line(const Receptance& structure, const Harmonics& harmonics, const Excitation& force, double omega,
                           bool with_slopes = false);

}  // namespace jointid::response
