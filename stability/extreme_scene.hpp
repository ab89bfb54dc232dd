#pragma once

#include <memory>
#include <vector>

#include "ident/plan/plan.hpp"
#include "stability/exact_identification.hpp"
#include "stability/exact_responses.hpp"

namespace jointid::stability {

/// What the joint's matrices are declared as.
enum class Form { springs, symmetric };

/// Two chains of four masses of about 1 kg, springs of about 1e6 N/m between neighbours and softer ones to the next but one,
/// joined by two springs with hysteretic damping between their ends: 3–5 and 4–6.
struct ExtremeScene {
  double joint_stiffness = 1.0;  ///< of spring 3–5 over 1e6 N/m
  double second_spring = 1.0;    ///< spring 4–6 over spring 3–5
  double joint_loss = 0.1;       ///< D over K of the joint
  double loss_factor = 0.01;     ///< D over K of the chains
  bool free_free = false;        ///< no spring to ground
  double gap = 1.0;              ///< compliance between 3 and 4, and 5 and 6, over that of the other springs: they coincide with 0
  double lowest_hz = 20.0, highest_hz = 350.0;
  bool logarithmic = false;      ///< lines equidistant in log f
  std::size_t lines = 12;
  bool on_resonance = false;     ///< every natural frequency of parts and assembly is a line
  Storage storage = Storage::double_precision;
  Form form = Form::springs;
  ident::Method method = ident::Method::one;
  weighting::Weighting weighting = weighting::Weighting::wb;
  std::uint64_t seed = 0;        ///< of small random changes of masses and springs; 0: regular steps
};

/// The FRFs, noise-free and rounded once, what identifies the joint, and its exact answer.
struct ExtremeProblem {
  Sets sets;
  ident::Scene scene;
  std::vector<double> truth;  ///< of the unknowns in the order of the restriction
  std::vector<std::size_t> group{};  ///< of each of them: those that are compared in size; empty: all

  std::unique_ptr<ident::Plan> plan(ident::Solver solver) const;
};

ExtremeProblem make(const ExtremeScene& scene);

}  // namespace jointid::stability
