#include "friction/path/parallel.hpp"

#include <algorithm>

namespace jointid::friction {
namespace {

template <class Figure>
double sum(const Parts& parts, Figure figure) {
  double total = 0.0;
  for (const auto& part : parts) total += figure(*part);
  return total;
}

}  // namespace

Response Parallel::response(double u) const {
  Response total;
  for (const auto& part : parts()) {
    const Response one = part->response(u);
    total.force += one.force;
    total.tangent += one.tangent;
  }
  return total;
}

double Parallel::energy(double u) const {
  return sum(parts(), [u](const Element& part) { return part.energy(u); });
}

double Parallel::limit() const {
  return sum(parts(), [](const Element& part) { return part.limit(); });
}

std::vector<double> Parallel::kinks() const {
  std::vector<double> all;
  for (const auto& part : parts()) {
    for (const double kink : part->kinks()) all.push_back(kink);
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void Parallel::derivative(double u, std::span<double> out) const {
  const auto stretches = split(out);
  for (std::size_t i = 0; i < stretches.size(); ++i) parts()[i]->derivative(u, stretches[i]);
}

std::unique_ptr<Element> Parallel::with(std::span<const double> values) const {
  return std::make_unique<Parallel>(parts_with(values));
}

double Parallel::cycle_energy(double u) const {
  return sum(parts(), [u](const Element& part) { return part.cycle_energy(u); });
}

double Parallel::equivalent_stiffness(double u) const {
  return sum(parts(), [u](const Element& part) { return part.equivalent_stiffness(u); });
}

double Parallel::second_moment(double u) const {
  return sum(parts(), [u](const Element& part) { return part.second_moment(u); });
}

void Parallel::second_moment_derivative(double u, std::span<double> out) const {
  const auto stretches = split(out);
  for (std::size_t i = 0; i < stretches.size(); ++i) parts()[i]->second_moment_derivative(u, stretches[i]);
}

}  // namespace jointid::friction
