#pragma once

#include "friction/law/bending_root.hpp"
#include "friction/law/listed_law.hpp"
#include "friction/law/menq_bar.hpp"

/// Menq's bar and the bending root as laws of the list: by their dimensions, and by what a loading curve tells of them.
namespace jointid::friction {

/// A law E of the list with the path of an element of other parameters.
template <class E, class Of>
class LawOf : public ListedLaw<E> {
 public:
  Response response(double u) const final { return element_.response(u); }
  double energy(double u) const final { return element_.energy(u); }
  double displacement(double force) const final { return element_.displacement(force); }
  double limit() const override { return element_.limit(); }
  std::vector<double> kinks() const final { return element_.kinks(); }
  double cycle_energy(double u) const final { return element_.cycle_energy(u); }

 protected:
  /// `make` gives the element of values that the law admits.
  LawOf(std::span<const double> values, Of (*make)(std::span<const double>)) : ListedLaw<E>(values), element_(make(values)) {}

  Of element_;
};

/// "menq": {EA, L, k, tau, beta}, a bar by its dimensions. A curve tells three of the five numbers, so it is no law of fits.
class MenqByDimensions final : public LawOf<MenqByDimensions, MenqBar> {
 public:
  static const Law law;

  explicit MenqByDimensions(std::span<const double> values);

  std::vector<Parameter> parameters() const override { return element_.parameters(); }
  void derivative(double u, std::span<double> out) const override { element_.derivative(u, out); }
};

/// "menq-shape": {f, u, lambda}: limit f = τL (N), displacement where slip begins u = τ/k (m), λ = L√(k/EA); far end free.
/// The bar has L = 1 m.
class MenqShape final : public LawOf<MenqShape, MenqBar> {
 public:
  static const Law law;

  explicit MenqShape(std::span<const double> values);

  double limit() const override { return limit_; }
  std::vector<Parameter> parameters() const override;
  void derivative(double u, std::span<double> out) const override;

 private:
  double limit_, slip_, length_;  ///< f, u, λ
};

/// "bending-root": {EI, tau, L0}, a clamped root by its dimensions. A curve tells two of the three numbers.
class RootByDimensions final : public LawOf<RootByDimensions, BendingRoot> {
 public:
  static const Law law;

  explicit RootByDimensions(std::span<const double> values);

  std::vector<Parameter> parameters() const override { return element_.parameters(); }
  void derivative(double u, std::span<double> out) const override { element_.derivative(u, out); }
};

/// "bending-root-shape": {k, f}: initial stiffness k = 3EI/L₀³ (N/m) and f = τL₀ (N); u = (f/k) times a function of F/f.
/// The root has L₀ = 1 m.
class RootShape final : public LawOf<RootShape, BendingRoot> {
 public:
  static const Law law;

  explicit RootShape(std::span<const double> values);

  std::vector<Parameter> parameters() const override;
  void derivative(double u, std::span<double> out) const override;

 private:
  double stiffness_, force_;
};

}  // namespace jointid::friction
