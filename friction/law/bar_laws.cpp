#include "friction/law/bar_laws.hpp"

#include <array>
#include <cmath>

namespace jointid::friction {
namespace {

constexpr std::array menq_parameters = {LawParameter{"EA", "N", 0.0, infinity}, LawParameter{"L", "m", 0.0, infinity},
                                        LawParameter{"k", "N/m^2", 0.0, infinity}, LawParameter{"tau", "N/m", 0.0, infinity},
                                        LawParameter{"beta", "N/m", 0.0, infinity, true}};
constexpr std::array menq_shape_parameters = {LawParameter{"f", "N", 0.0, infinity}, LawParameter{"u", "m", 0.0, infinity},
                                              LawParameter{"lambda", "1", 0.0, 1e4}};
constexpr std::array menq_lengths = {0.5, 2.0, 8.0};

constexpr std::array root_parameters = {LawParameter{"EI", "N*m^2", 0.0, infinity}, LawParameter{"tau", "N/m", 0.0, infinity},
                                        LawParameter{"L0", "m", 0.0, infinity}};
constexpr std::array root_shape_parameters = {LawParameter{"k", "N/m", 0.0, infinity}, LawParameter{"f", "N", 0.0, infinity}};
constexpr std::array root_forces = {1.0, 10.0, 100.0};

/// The stiffness while nothing slips is f tanh λ/(uλ).
std::vector<double> menq_start(const Features& seen, double lambda) {
  return {seen.limit, seen.limit * std::tanh(lambda) / (seen.stiffness * lambda), lambda};
}

std::vector<double> root_start(const Features& seen, double forces) { return {seen.stiffness, forces * seen.limit}; }

MenqBar bar_of(std::span<const double> values) { return MenqBar({values[0], values[1], values[2], values[3], values[4]}); }

MenqBar bar_of_shape(std::span<const double> values) {
  const double f = values[0], u = values[1], lambda = values[2];
  return MenqBar({.axial_stiffness = f / (u * lambda * lambda), .length = 1.0, .interface_stiffness = f / u, .slip_force = f});
}

BendingRoot root_of(std::span<const double> values) { return BendingRoot(values[0], values[1], values[2]); }

BendingRoot root_of_shape(std::span<const double> values) { return BendingRoot(values[0] / 3.0, values[1], 1.0); }

}  // namespace

const Law MenqByDimensions::law = {"menq", "elastic bar on dry friction (Menq)", menq_parameters, {{}, nullptr}};

MenqByDimensions::MenqByDimensions(std::span<const double> values) : LawOf(values, bar_of) {}

const Law MenqShape::law = {
    "menq-shape", "elastic bar on dry friction, by its curve (Menq)", menq_shape_parameters, {menq_lengths, menq_start}};

MenqShape::MenqShape(std::span<const double> values)
    : LawOf(values, bar_of_shape), limit_(values[0]), slip_(values[1]), length_(values[2]) {}

std::vector<Parameter> MenqShape::parameters() const { return with_values(law, std::array{limit_, slip_, length_}); }

/// EA = f/(uλ²), k = f/u, τ = f.
void MenqShape::derivative(double u, std::span<double> out) const {
  std::array<double, 5> by{};
  element_.derivative(u, by);
  const double ea = by[0] / (slip_ * length_ * length_), k = by[2] / slip_;
  out[0] = ea + k + by[3];
  out[1] = -(ea + k) * limit_ / slip_;
  out[2] = -2.0 * ea * limit_ / length_;
}

const Law RootByDimensions::law = {
    "bending-root", "clamped root of a bending beam with dry friction", root_parameters, {{}, nullptr}, false};

RootByDimensions::RootByDimensions(std::span<const double> values) : LawOf(values, root_of) {}

const Law RootShape::law = {"bending-root-shape",
                            "clamped root of a bending beam, by its curve",
                            root_shape_parameters,
                            {root_forces, root_start},
                            false};

RootShape::RootShape(std::span<const double> values)
    : LawOf(values, root_of_shape), stiffness_(values[0]), force_(values[1]) {}

std::vector<Parameter> RootShape::parameters() const { return with_values(law, std::array{stiffness_, force_}); }

void RootShape::derivative(double u, std::span<double> out) const {
  std::array<double, 3> by{};
  element_.derivative(u, by);
  out[0] = by[0] / 3.0;
  out[1] = by[1];
}

}  // namespace jointid::friction
