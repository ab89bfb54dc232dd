#include "friction/law/spring.hpp"

#include <array>

namespace jointid::friction {
namespace {

constexpr std::array spring_parameters = {LawParameter{"k", "N/m", 0.0, infinity}};
constexpr std::array spring_shapes = {0.0};

std::vector<double> spring_start(const Features& f, double) { return {f.stiffness}; }

}  // namespace

const Law Spring::law = {"spring", "linear spring", spring_parameters, {spring_shapes, spring_start}, false};

Spring::Spring(std::span<const double> values) : ListedLaw(values) {
  stiffness_ = values[0];
}

Response Spring::response(double u) const { return {stiffness_ * u, stiffness_}; }
double Spring::energy(double u) const { return 0.5 * stiffness_ * u * u; }
double Spring::displacement(double force) const { return force / stiffness_; }
void Spring::derivative(double u, std::span<double> out) const { out[0] = u; }
double Spring::cycle_energy(double) const { return 0.0; }
double Spring::equivalent_stiffness(double) const { return stiffness_; }
double Spring::second_moment(double u) const { return stiffness_ * u * u * u * u / 4.0; }

void Spring::second_moment_derivative(double u, std::span<double> out) const { out[0] = u * u * u * u / 4.0; }

}  // namespace jointid::friction
