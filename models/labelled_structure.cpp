#include "models/labelled_structure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "models/matrix_value.hpp"
#include "models/model_units.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

struct ReadMatrix {
  scene::Item item;
  FileMatrix value;
};

/// The same matrix with its rows in the order of `labels`.
Sparse placed(const Sparse& matrix, const std::vector<RowLabel>& own, const std::vector<RowLabel>& labels) {
  if (own == labels || matrix.rows() == 0) return matrix;
  std::vector<int> place;
  for (const RowLabel& label : own) place.push_back(static_cast<int>(std::ranges::lower_bound(labels, label) - labels.begin()));
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
      entries.emplace_back(place[static_cast<std::size_t>(entry.row())], place[static_cast<std::size_t>(j)], entry.value());
  }
  Sparse out(at(labels.size()), at(labels.size()));
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

/// Throws where two coordinates alone would move with negative energy: a number was cut off, or a sign is turned. Below a
/// millionth of the largest element it is rounding.
void require_energy(const scene::Item& item, const Sparse& matrix) {
  constexpr double rounding = 1e-6;
  const Eigen::VectorXd diagonal = matrix.diagonal();
  const double least = matrix.nonZeros() > 0 ? rounding * matrix.coeffs().abs().maxCoeff() : 0.0;
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry) {
      const double first = diagonal[entry.row()], second = diagonal[j],
                   bound = std::sqrt(std::max(0.0, first) * std::max(0.0, second));
      const bool negative = entry.row() == j && entry.value() < -least;
      if (!negative && std::abs(entry.value()) <= bound + least) continue;
      const std::string place = "element (" + std::to_string(entry.row() + 1) + ", " + std::to_string(j + 1) + ") is ";
      item.fail(
          place + digits(entry.value(), "%.6g") +
              (negative ? "" : ", and those on the diagonal are " + digits(first, "%.6g") + " and " + digits(second, "%.6g")),
          "mass, damping and stiffness have no negative energy. Look for a number that is cut off, or for a sign");
    }
  }
}

NamedCoordinates named(const std::vector<RowLabel>& labels) {
  NamedCoordinates out;
  for (std::size_t row = 0; row < labels.size(); ++row) {
    if (labels[row].node < 1 || labels[row].component < 1 || labels[row].component > 6) continue;
    out.dofs.push_back({labels[row].node, static_cast<frf::Direction>(labels[row].component), +1});
    out.coordinates.push_back(row);
  }
  return out;
}

/// The labels of all; none where no file has them.
std::vector<RowLabel> labels_of(const std::map<std::string, ReadMatrix>& read) {
  std::vector<RowLabel> all;
  for (const auto& [key, each] : read) {
    std::vector<RowLabel> both;
    std::ranges::set_union(all, each.value.labels, std::back_inserter(both));
    all = std::move(both);
  }
  if (all.empty()) return all;
  for (const auto& [key, each] : read) {
    if (each.value.labels.empty())
      each.item.fail("its rows have no labels, and those of another matrix have",
                     "give all matrices in files that label their rows, or none");
  }
  return all;
}

}  // namespace

LabelledStructure read_structure(const scene::Table& table, const std::filesystem::path& folder) {
  constexpr std::array keys = {"mass", "stiffness", "viscous_damping", "hysteretic_damping"};
  std::map<std::string, ReadMatrix> read;
  for (const char* key : keys) {
    const auto item = table.find(key);
    if (item) read.emplace(key, ReadMatrix{*item, read_labelled_value(*item, folder)});
  }
  LabelledStructure out;
  const std::vector<RowLabel> labels = labels_of(read);
  out.coordinates = named(labels);
  StructureMatrices& to = out.matrices;
  const std::array<Sparse*, 4> places = {&to.mass, &to.stiffness, &to.viscous_damping, &to.hysteretic_damping};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto found = read.find(keys[i]);
    if (found == read.end()) continue;
    const auto& [item, value] = found->second;
    if (!value.stated_unit.empty() && !table.find("units")) item.fail("the file states " + value.stated_unit, give_model_units);
    const bool is_complex = value.imaginary.nonZeros() > 0;
    if (is_complex && std::string(keys[i]) != "stiffness")
      item.fail("the matrix is complex", "only the stiffness of a model may be: K + iD");
    if (is_complex && read.contains("hysteretic_damping"))
      item.fail("the stiffness is complex, K + iD, and there is a hysteretic_damping, too", "give one of them");
    require_energy(item, value.real);
    if (is_complex) require_energy(item, value.imaginary);
    *places[i] = placed(value.real, value.labels, labels);
    if (is_complex) to.hysteretic_damping = placed(value.imaginary, value.labels, labels);
    if (places[i]->rows() != to.mass.rows())
      item.fail("the matrix has " + std::to_string(places[i]->rows()) + " rows, the mass matrix " +
                std::to_string(to.mass.rows()));
  }
  return out;
}

}  // namespace jointid::models
