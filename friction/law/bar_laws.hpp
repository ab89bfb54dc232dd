#pragma once

#include "friction/law/bending_root.hpp"
#include "friction/law/listed_law.hpp"
#include "friction/law/menq_bar.hpp"

/// Menq's bar and the bending root as laws of the list: by their dimensions, and by what a loading curve tells of them.
namespace jointid::friction {

/// "menq": {EA, L, k, tau, beta}, a bar by its dimensions. A curve tells three of the five numbers, so it is no law of fits.
class MenqByDimensions final : public ListedLaw<MenqByDimensions> {
 public:
  static const Law law;

  explicit MenqByDimensions(std::span<const double> values);

  Response response(double u) const override { return bar_.response(u); }
  double energy(double u) const override { return bar_.energy(u); }
  double displacement(double force) const override { return bar_.displacement(force); }
  double limit() const override { return bar_.limit(); }
  std::vector<double> kinks() const override { return bar_.kinks(); }
  std::vector<Parameter> parameters() const override { return bar_.parameters(); }
  void derivative(double u, std::span<double> out) const override { bar_.derivative(u, out); }

 private:
  MenqBar bar_;
};

/// "menq-shape": {f, u, lambda}: limit f = τL (N), displacement where slip begins u = τ/k (m), λ = L√(k/EA); far end free.
class MenqShape final : public ListedLaw<MenqShape> {
 public:
  static const Law law;

  explicit MenqShape(std::span<const double> values);

  Response response(double u) const override { return bar_.response(u); }
  double energy(double u) const override { return bar_.energy(u); }
  double displacement(double force) const override { return bar_.displacement(force); }
  double limit() const override { return limit_; }
  std::vector<double> kinks() const override { return bar_.kinks(); }
  std::vector<Parameter> parameters() const override;
  void derivative(double u, std::span<double> out) const override;

 private:
  double limit_, slip_, length_;  ///< f, u, λ
  MenqBar bar_;                   ///< of L = 1 m
};

/// "bending-root": {EI, tau, L0}, a clamped root by its dimensions. A curve tells two of the three numbers.
class RootByDimensions final : public ListedLaw<RootByDimensions> {
 public:
  static const Law law;

  explicit RootByDimensions(std::span<const double> values);

  Response response(double u) const override { return root_.response(u); }
  double energy(double u) const override { return root_.energy(u); }
  double displacement(double force) const override { return root_.displacement(force); }
  double limit() const override { return infinity; }
  std::vector<Parameter> parameters() const override { return root_.parameters(); }
  void derivative(double u, std::span<double> out) const override { root_.derivative(u, out); }
  double cycle_energy(double u) const override { return root_.cycle_energy(u); }

 private:
  BendingRoot root_;
};

/// "bending-root-shape": {k, f}: initial stiffness k = 3EI/L₀³ (N/m) and f = τL₀ (N); u = (f/k) times a function of F/f.
class RootShape final : public ListedLaw<RootShape> {
 public:
  static const Law law;

  explicit RootShape(std::span<const double> values);

  Response response(double u) const override { return root_.response(u); }
  double energy(double u) const override { return root_.energy(u); }
  double displacement(double force) const override { return root_.displacement(force); }
  double limit() const override { return infinity; }
  std::vector<Parameter> parameters() const override;
  void derivative(double u, std::span<double> out) const override;
  double cycle_energy(double u) const override { return root_.cycle_energy(u); }

 private:
  double stiffness_, force_;
  BendingRoot root_;  ///< of L₀ = 1 m
};

}  // namespace jointid::friction
