#include "friction/path/assembly.hpp"

#include <numeric>

#include "base/error.hpp"

namespace jointid::friction {

Assembly::Assembly(Parts parts) : parts_(std::move(parts)) {
  if (parts_.empty()) refuse("assembly of friction elements: no element");
  for (const auto& part : parts_) sizes_.push_back(part->parameters().size());
}

std::vector<Parameter> Assembly::parameters() const {
  std::vector<Parameter> result;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (Parameter parameter : parts_[i]->parameters()) {
      parameter.name = std::to_string(i + 1) + "." + parameter.name;
      result.push_back(std::move(parameter));
    }
  }
  return result;
}

bool Assembly::sizes_agree(std::span<const double> values) const {
  return values.size() == std::accumulate(sizes_.begin(), sizes_.end(), std::size_t{0});
}

bool Assembly::admits(std::span<const double> values) const {
  if (!sizes_agree(values)) return false;
  for (std::size_t i = 0, first = 0; i < parts_.size(); first += sizes_[i++]) {
    if (!parts_[i]->admits(values.subspan(first, sizes_[i]))) return false;
  }
  return true;
}

Parts Assembly::parts_with(std::span<const double> values) const {
  if (!sizes_agree(values)) {
    refuse("assembly of friction elements: " + std::to_string(values.size()) + " values");
  }
  Parts result;
  for (std::size_t i = 0, first = 0; i < parts_.size(); first += sizes_[i++]) {
    result.push_back(parts_[i]->with(values.subspan(first, sizes_[i])));
  }
  return result;
}

std::vector<std::span<double>> Assembly::split(std::span<double> out) const {
  std::vector<std::span<double>> result;
  for (std::size_t i = 0, first = 0; i < parts_.size(); first += sizes_[i++]) {
    result.push_back(out.subspan(first, sizes_[i]));
  }
  return result;
}

}  // namespace jointid::friction
