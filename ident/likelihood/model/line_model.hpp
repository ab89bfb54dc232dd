#pragma once

#include <memory>
#include <optional>

#include "ident/likelihood/elimination/arrow_elimination.hpp"
#include "ident/likelihood/elimination/line_elimination.hpp"
#include "ident/likelihood/rows/complex_rows.hpp"
#include "ident/likelihood/rows/correlated_rows.hpp"
#include "ident/likelihood/line/line_state.hpp"
#include "ident/likelihood/rows/normal_rows.hpp"
#include "ident/likelihood/rows/plain_rows.hpp"
#include "ident/likelihood/line/reduced_line.hpp"

namespace jointid::ident {

/// The linearised line (docs/formulas.md §11e). With P = (I + Y Z)⁻¹, G = Z A, R = X − A − Y Z A:
///   δA = P (R + δX − δY G − Y δZ A),  δD(r,k) = G_kᵀ δX_r + h_r (R_k + δX_k − δY G_k) + (X_rᵀ − h_r Y) δZ A_k,
/// h = Xᵀ Z P, and likewise for B. Eliminating δA, δB and H(n,n), which stands alone in its rows, leaves δX, δY and δθ: the
/// step is that of the implicit errors-in-variables problem (Gauss–Helmert), and on the constraint, where R = 0, that of the
/// explicit one (Gauss–Newton). Not thread-safe: one per thread.
///
/// All of it is linear in complex numbers. Where real and imaginary part of every FRF have the same weight (circular errors) the
/// normal equations are complex, half as many, and taken so for lines of many FRFs and where errors depend on each other. Those of
/// many FRFs with independent errors are solved by their structure: by LineElimination where that takes fewer flops, else by
/// ArrowElimination.
class LineModel {
 public:
  enum class Numbers {
    chosen,
    real,
    complex,    ///< where errors are circular, by rows
    blocks,     ///< by ArrowElimination where they are circular and independent
    eliminated  ///< by LineElimination where they are circular and independent, and it can
  };

  explicit LineModel(const LineLayout& layout, Numbers numbers = Numbers::chosen)
      : layout_(layout), numbers_(numbers), plain_rows_(layout) {}

  const LineLayout& layout() const { return layout_; }

  /// Linearises at `state`; `with_joint`: the unknowns of the joint too, followed by those of the systematic errors that `data` is
  /// corrected for (corrected_line()).
  void linearise(const LineData& data, const JointImpedance& joint, const ComplexMatrix& z, const LineState& state,
                 bool with_joint);

  /// What advance() needs of linearise().
  void prepare(const ComplexMatrix& z, const LineState& state);

  /// Eliminates the FRFs, with damping · weight² added for measured X and Y (relative to a wide guess for those not measured).
  /// Empty when the FRFs are not determined without more damping. Without `answer` there is no way back to the FRFs: where rows are
  /// eliminated by Cholesky factors that saves half of what right-hand sides cost.
  std::optional<ReducedLine> reduce(double damping, bool answer = true);

  /// U⁻¹g for another g, by the factors of the last reduce() that had a result.
  LineStep own_step(const LineStep& gradient) const;

  /// Moves all of the state that linearise() or prepare() got, A and B along the linearised constraint, by a step of X and Y and by δZ.
  void advance(const LineStep& step, const ComplexMatrix& dz, LineState& state) const;

 private:
  bool are_circular(const LineData& data) const;
  bool are_plain() const { return !complex_ && !correlation_; }  ///< equations that PlainRows takes
  bool eliminates(const JointImpedance& joint);
  StructuredLine* by_structure(const LineData& data, const LineState& state, const LineFactors& factors, const JointImpedance& joint);
  std::optional<ReducedLine> reduce_real(double damping, bool answer);
  std::optional<ReducedLine> reduce_complex(double damping, bool answer);
  void add_priors(const LineData& data, const LineState& state);
  void add_prior(std::size_t variable, Complex residual, Complex weight, double guess);
  void put_systematic_prior(std::size_t variable, const Channel& channel, std::size_t i, Complex current);
  void add_prior_terms(std::size_t variable, Complex residual, Complex weight);
  bool put_correlated_prior(std::size_t variable, Complex residual, Complex weight);
  void add_a(const LineData& data, const JointImpedance& joint, const LineState& state);
  void add_b(const LineData& data, const JointImpedance& joint, const LineState& state);
  void add_d(const LineData& data, const JointImpedance& joint, const LineState& state);
  NormalRows::Run column(std::size_t other) const;
  void put(Complex coefficient);
  void put_y(const Complex* left, const ComplexMatrix& right, Eigen::Index right_column);
  void put_joint(const JointImpedance& joint, const Complex* left, const Complex* right);
  void put_systematic(std::size_t element, Complex residual);
  void emit(const Channel& channel, std::size_t i, Complex predicted, NormalRows::Run first, NormalRows::Run second);
  void put_correlated(minimise::Correlation::Place place, Complex weight, NormalRows::Run first, NormalRows::Run second);

  const LineLayout& layout_;
  Numbers numbers_;
  bool complex_ = false;      ///< the normal equations of the line
  std::pair<std::size_t, bool> pays_{0, false};  ///< elimination_pays() for so many right-hand sides
  StructuredLine* structured_ = nullptr;  ///< what solves them instead of rows
  std::size_t unknowns_ = 0;  ///< of the joint, and of systematic errors
  std::size_t joint_unknowns_ = 0;
  std::size_t place_ = 0;     ///< in the row that is being written
  std::vector<Complex> row_;  ///< FRFs that it touches, the joint's unknowns, those of systematic errors, residual
  ComplexMatrix p_, py_, za_, h_, yh_, r_, pr_;
  ComplexMatrix c_, rest_b_, pr_b_;  ///< where B is measured: I − Z B, Y − B − Y Z B, and P times that
  std::vector<double> prior_weight_;  ///< 2v, v of complex equations
  NormalRows rows_;
  PlainRows plain_rows_;
  ComplexRows complex_rows_;
  std::unique_ptr<LineElimination> elimination_;        ///< once it is used
  std::unique_ptr<ArrowElimination> arrow_;             ///< likewise
  const minimise::Correlation* correlation_ = nullptr;  ///< of the line's errors
  const SystematicTerms* terms_ = nullptr;    ///< of the line, while unknowns are asked for
  std::size_t first_element_ = 0;             ///< of the channel whose rows are written, see Correlation
  CorrelatedRows correlated_rows_;
  Eigen::VectorXd scale_;         ///< of the FRFs in the complex factors
  ComplexMatrix factor_, right_;  ///< of reduce_complex()
  std::vector<double> real_factor_, solved_;  ///< of reduce_real()
};

}  // namespace jointid::ident
