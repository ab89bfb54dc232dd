#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace jointid::ident {

/// An undamped structure whose joints may lack a share of their stiffness: K = `stiffness` + Σ (1 − lost_u) K_u, K_u by elements.
struct SharedStiffness {
  struct Element {
    Eigen::Index row = 0, column = 0;
    double value = 0.0;
  };
  Eigen::MatrixXd mass, stiffness;
  std::vector<std::vector<Element>> of_joint;

  std::size_t joints() const { return of_joint.size(); }
};

/// ln ω² of the lowest elastic modes, and their derivatives by the lost shares [modes, joints].
struct ElasticModes {
  Eigen::VectorXd logarithm;
  Eigen::MatrixXd by_lost;
};

/// Motions without strain energy, to rounding of the highest mode, are no elastic ones. Throws InputError where the mass is not positive
/// definite or there are fewer modes.
ElasticModes elastic_modes(const SharedStiffness& of, const Eigen::VectorXd& lost, Eigen::Index count);

/// The joints that explain a structure's lowest elastic eigenfrequencies.
struct LooseFit {
  Eigen::VectorXd lost;       ///< 0 for a joint that is taken for sound
  Eigen::VectorXd std_error;  ///< of the loose ones, by the misfit; else 0
  double misfit = 0.0;        ///< rms of f/f_measured − 1 over the degrees of freedom
  double before = 0.0;        ///< the same with all joints sound
  std::size_t solutions = 0;  ///< of the eigenvalue problem
};

inline constexpr double most_lost = 0.95;

/// min ½ Σ (ln f − ln f_measured)²/σ² + λ Σ lost, 0 ≤ lost ≤ most_lost, from λ so large that no joint is loose downwards: the sign of
/// `lost` makes the ℓ₁ norm linear. Each set of joints that it leaves loose is fitted without λ; the set is the one of least
/// n ln(rss/n) + k (ln n + 2 ln p). All frequencies count alike, σ need not be known. `watch` is called before each solution of the
/// eigenvalue problem and may throw.
LooseFit fit_loose_joints(const SharedStiffness& structure, const std::vector<double>& frequency_hz, const std::function<void()>& watch);

}  // namespace jointid::ident
