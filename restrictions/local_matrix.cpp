#include "restrictions/local_matrix.hpp"

#include <cmath>
#include <map>

#include "base/error.hpp"
#include "restrictions/linear_expression.hpp"
#include "restrictions/unit.hpp"

namespace jointid::restrictions {
namespace {

std::string element(std::size_t row, std::size_t column) {
  return "(" + std::to_string(row + 1) + "," + std::to_string(column + 1) + ")";
}

void check_size(const JointSpec& joint, Kind kind, const EntryMatrix& entries) {
  const std::size_t size = joint.dofs.size();
  const std::string expected = "the joint has " + std::to_string(size) + " DOFs";
  if (entries.size() != size) {
    fail(joint, kind, "the matrix has " + std::to_string(entries.size()) + " rows, but " + expected,
         "give it a row and a column for each");
  }
  for (std::size_t row = 0; row < size; ++row) {
    if (entries[row].size() == size) continue;
    fail(joint, kind,
         "row " + std::to_string(row + 1) + " has " + std::to_string(entries[row].size()) + " elements, but " +
             expected,
         "give the matrix a row and a column for each");
  }
}

LinearExpression parse_entry(const JointSpec& joint, Kind kind, const Entry& entry, std::size_t row,
                             std::size_t column) {
  if (const double* number = std::get_if<double>(&entry)) {
    if (!std::isfinite(*number)) fail(joint, kind, "element " + element(row, column) + " is not finite", "");
    return {*number, {}};
  }
  try {
    return parse_linear(std::get<std::string>(entry));
  } catch (const InputError& error) {
    fail(joint, kind, "element " + element(row, column) + ": " + error.parts().problem, error.parts().remedy);
  }
}

/// Collects the entries of a matrix; a named unknown gets its index and its unit where it first appears.
class EntryCollector {
 public:
  EntryCollector(const JointSpec& joint, Kind kind) : joint_(joint), kind_(kind) {}

  void add(std::size_t row, std::size_t column, const LinearExpression& expression) {
    matrix_.known.push_back({row, column, expression.constant});
    for (const LinearTerm& term : expression.terms) {
      const auto [place, is_new] = index_.try_emplace(term.name, index_.size());
      if (is_new) {
        matrix_.unknowns.push_back({symbol(kind_) + "." + term.name, {}});
        units_.emplace_back();
      }
      units_[place->second].add(kind_, joint_.dofs[row], joint_.dofs[column]);
      matrix_.terms.push_back({row, column, place->second, term.coefficient});
    }
  }

  LocalMatrix take() {
    for (std::size_t i = 0; i < units_.size(); ++i) matrix_.unknowns[i].unit = units_[i].text();
    return std::move(matrix_);
  }

 private:
  const JointSpec& joint_;
  Kind kind_;
  LocalMatrix matrix_;
  std::map<std::string, std::size_t> index_;
  std::vector<SharedUnit> units_;
};

}  // namespace

void fail(const JointSpec& joint, Kind kind, const std::string& problem, const std::string& remedy) {
  const std::string place =
      joint.name.empty() ? "[joint." + key(kind) + "]" : "joint '" + joint.name + "', " + key(kind);
  throw InputError(
      {.kind = ErrorKind::usage, .file = {}, .place = place, .problem = problem, .remedy = remedy});
}

LocalMatrix from_pattern(const JointSpec& joint, Kind kind, Pattern pattern) {
  LocalMatrix matrix;
  const std::size_t size = joint.dofs.size();
  for (std::size_t row = 0; row < size; ++row) {
    const std::size_t begin = pattern == Pattern::full ? 0 : row;
    const std::size_t end = pattern == Pattern::diagonal ? row + 1 : size;
    for (std::size_t column = begin; column < end; ++column) {
      const std::size_t unknown = matrix.unknowns.size();
      matrix.unknowns.push_back(
          {symbol(kind) + element(row, column), unit(kind, joint.dofs[row], joint.dofs[column])});
      matrix.terms.push_back({row, column, unknown, 1.0});
      if (pattern == Pattern::symmetric && column != row) matrix.terms.push_back({column, row, unknown, 1.0});
    }
  }
  return matrix;
}

LocalMatrix from_entries(const JointSpec& joint, Kind kind, const EntryMatrix& entries) {
  check_size(joint, kind, entries);
  EntryCollector collector(joint, kind);
  for (std::size_t row = 0; row < entries.size(); ++row) {
    for (std::size_t column = 0; column < entries.size(); ++column) {
      collector.add(row, column, parse_entry(joint, kind, entries[row][column], row, column));
    }
  }
  return collector.take();
}

}  // namespace jointid::restrictions
