#include "ident/check/repeated_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/plan/data_source.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;

constexpr std::size_t lines_of_runs = 4;
constexpr double same_share = 1e-12;  ///< of the squares

std::vector<Complex> some_values(frf::FrfSource& source) {
  std::vector<std::size_t> rows(source.header().response.size()), columns(source.header().reference.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = i;
  const std::vector<std::size_t> lines = spread_lines(source.header().lines(), lines_of_runs);
  const frf::Block block{lines, rows, columns};
  std::vector<Complex> values(block.size());
  source.read(block, values);
  return values;
}

bool are_same(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (!std::isfinite(std::norm(a[i])) || !std::isfinite(std::norm(b[i]))) continue;
    difference += std::norm(a[i] - b[i]);
    size += std::norm(a[i]);
  }
  return a.size() == b.size() && size > 0.0 && difference <= same_share * size;
}

/// Equal at all lines, and not zero.
bool are_same(const CheckedFile& file, Index r, Index c, Index other_r, Index other_c) {
  bool any = false;
  for (const Eigen::MatrixXcd& line : file.frfs) {
    const Complex a = line(r, c), b = line(other_r, other_c);
    if (!std::isfinite(std::norm(a)) && !std::isfinite(std::norm(b))) continue;
    if (!(std::norm(a - b) <= 1e-24 * std::norm(a))) return false;
    any = any || a != 0.0;
  }
  return any;
}

/// Whether the numbers of a file have errors of their own: by its record, or since half of its pairs H_ij, H_ji differ by more than
/// rounding. Where they have none, symmetry of the structure makes FRFs equal.
bool has_noise(const CheckedFile& file) {
  if (file.has_recorded_noise()) return true;
  constexpr double rounding = 1e-20;  // of the squares
  std::size_t pairs = 0, different = 0;
  const Eigen::MatrixXcd& line = file.frfs[file.frfs.size() / 2];
  for (std::size_t c = 0; c < file.references.size(); ++c) {
    const std::size_t r = place_of(file.responses, file.references[c]);
    for (std::size_t d = 0; r != frf::npos && d < c; ++d) {
      const std::size_t s = place_of(file.responses, file.references[d]);
      if (s == frf::npos) continue;
      const Complex there = line(at(s), at(c)), back = line(at(r), at(d));
      ++pairs;
      if (std::norm(there - back) > rounding * std::norm(there)) ++different;
    }
  }
  return 2 * different > pairs;
}

Suspect copied(const CheckedFile& file, Dofs dofs, const std::string& evidence) {
  return {.kind = SuspectKind::copy,
          .file = file.name,
          .dofs = std::move(dofs),
          .evidence = evidence,
          .confidence = 0.95,
          .remedy = ""};
}

bool is_equal_column(const CheckedFile& file, Index a, Index b) {
  for (Index r = 0; r < at(file.responses.size()); ++r) {
    if (!are_same(file, r, a, r, b)) return false;
  }
  return true;
}

std::vector<Suspect> equal_columns(const CheckedFile& file) {
  std::vector<Suspect> found;
  for (std::size_t b = 1; b < file.references.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!is_equal_column(file, at(a), at(b))) continue;
      const frf::Dof &one = file.references[a], &other = file.references[b];
      found.push_back(copied(file, {one, other},
                             "the FRFs to the references " + one.name() + " and " + other.name() +
                                 " are the same numbers: one measurement under two labels"));
      break;
    }
  }
  return found;
}

/// Pairs of responses whose FRFs to a reference are the same number at one line.
std::vector<std::pair<Index, Index>> candidates(const Eigen::MatrixXcd& line, Index reference) {
  std::vector<std::pair<double, Index>> sizes;
  for (Index r = 0; r < line.rows(); ++r) {
    if (const double size = std::norm(line(r, reference)); std::isfinite(size) && size > 0.0) sizes.emplace_back(size, r);
  }
  std::ranges::sort(sizes);
  std::vector<std::pair<Index, Index>> out;
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    if (sizes[k].first - sizes[k - 1].first <= same_share * sizes[k].first)
      out.push_back(std::minmax(sizes[k - 1].second, sizes[k].second));
  }
  return out;
}

std::vector<Suspect> equal_cells(const CheckedFile& file) {
  constexpr std::size_t most = 3;  // more are made by symmetry
  std::vector<Suspect> found;
  for (std::size_t c = 0; c < file.references.size(); ++c) {
    for (const auto& [one, other] : candidates(file.frfs[file.frfs.size() / 2], at(c))) {
      if (!are_same(file, one, at(c), other, at(c))) continue;
      if (found.size() == most) return {};
      const frf::Dof &a = file.responses[static_cast<std::size_t>(one)], &b = file.responses[static_cast<std::size_t>(other)];
      found.push_back(copied(file, {a, b},
                             "the FRFs of " + a.name() + " and " + b.name() + " to the reference " + file.references[c].name() +
                                 " are the same numbers: one of them is a copy"));
    }
  }
  return found;
}

}  // namespace

std::vector<Suspect> find_equal_runs(const Scene& scene) {
  std::vector<Suspect> found;
  for (const auto* files : {&scene.data.substructures, &scene.data.assembly}) {
    for (const DataFile& file : *files) {
      if (file.repeats.empty()) continue;
      std::vector<DataFile> runs = {file};
      runs.front().repeats.clear();
      runs.insert(runs.end(), file.repeats.begin(), file.repeats.end());
      const Sources sources = open_all(runs);
      std::vector<std::vector<Complex>> values;
      for (std::size_t b = 0; b < runs.size(); ++b) {
        values.push_back(some_values(*sources[b]));
        for (std::size_t a = 0; a < b; ++a) {
          if (!are_same(values[a], values[b])) continue;
          const std::string one = runs[a].path.filename().string(), other = runs[b].path.filename().string();
          found.push_back({.kind = SuspectKind::copy,
                           .file = other,
                           .dofs = {},
                           .evidence = "the two runs " + one + " and " + other +
                                       " are the same numbers: their scatter, which should give the noise, is zero",
                           .confidence = 0.99,
                           .remedy = "# give the file of the other run, or take " + other + " out of the scene"});
          break;
        }
      }
    }
  }
  return found;
}

std::vector<Suspect> find_copied_columns(const CheckedFile& file) {
  if (file.frfs.size() < 3 || !has_noise(file)) return {};
  std::vector<Suspect> found = equal_columns(file);
  if (found.empty()) found = equal_cells(file);
  return found;
}

}  // namespace jointid::ident
