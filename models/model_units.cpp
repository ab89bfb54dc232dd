#include "models/model_units.hpp"

#include <optional>
#include <vector>

#include "frf/set/unit_label.hpp"

namespace jointid::models {
namespace {

constexpr const char* write_units =
    "write a length and a force, and a mass where it is another one: \"mm, N, t\", \"mm, N, kg\", \"in, lbf\"";

std::vector<std::string> words_of_units(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    const bool between = c == ',' || c == ';' || c == ' ' || c == '-';
    if (!between) words.back() += c;
    if (between && !words.back().empty()) words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// 1, or the length where a coordinate is a rotation, of each coordinate of a model.
Eigen::VectorXd scales(const NamedCoordinates& coordinates, Eigen::Index size, double length) {
  Eigen::VectorXd out = Eigen::VectorXd::Ones(size);
  for (std::size_t i = 0; i < coordinates.dofs.size(); ++i) {
    if (coordinates.dofs[i].is_rotation()) out(static_cast<Eigen::Index>(coordinates.coordinates[i])) = length;
  }
  return out;
}

void scale(Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& of_coordinates, double factor) {
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry)
      entry.valueRef() *= factor * of_coordinates(entry.row()) * of_coordinates(j);
  }
}

}  // namespace

void ModelUnits::apply(StructureMatrices& matrices, const NamedCoordinates& coordinates) const {
  const Eigen::VectorXd of = scales(coordinates, matrices.mass.rows(), length);
  scale(matrices.mass, of, mass);
  for (Eigen::SparseMatrix<double>* each : {&matrices.stiffness, &matrices.viscous_damping, &matrices.hysteretic_damping})
    scale(*each, of, force / length);
}

void ModelUnits::apply(Modes& modes, const NamedCoordinates& coordinates) const {
  const Eigen::VectorXd of = scales(coordinates, modes.normal_shapes.rows(), length).cwiseInverse();
  modes.normal_shapes = (of.asDiagonal() * modes.normal_shapes).eval();
  for (NormalMode& mode : modes.normal) mode.modal_mass *= mass;
  if (modes.residual.size() > 0) modes.residual = (length / force * (of.asDiagonal() * modes.residual * of.asDiagonal())).eval();
}

ModelUnits read_model_units(const scene::Item& item) {
  std::optional<double> length, force, mass;
  for (const std::string& word : words_of_units(item.text_not_empty())) {
    const auto unit = frf::parse_unit(word == "t" ? "tonne" : word);
    std::optional<double>* place = nullptr;
    if (unit && unit->same_dimension({1.0, 1, 0, 0})) place = &length;
    if (unit && unit->same_dimension({1.0, 0, 0, 1})) place = &force;
    if (unit && unit->same_dimension({1.0, -1, 2, 1})) place = &mass;
    if (unit && unit->same_dimension({1.0, 0, 1, 0}) && unit->si == 1.0) continue;
    if (place == nullptr) item.fail("'" + word + "' is no unit of a length, a force or a mass", write_units);
    if (*place) item.fail("'" + word + "' is the second unit of its kind", write_units);
    *place = unit->si;
  }
  if (!length || !force) item.fail(!length ? "a length is missing" : "a force is missing", write_units);
  return {*length, *force, mass.value_or(*force / *length)};
}

}  // namespace jointid::models
