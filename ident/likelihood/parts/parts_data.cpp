#include "ident/likelihood/parts/parts_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/complex.hpp"
#include "base/eigen.hpp"

namespace jointid::ident {
namespace {

bool is_measured(const Complex& value, const Complex& variance) {
  return std::isfinite(value.real()) && std::isfinite(value.imag()) && std::isfinite(variance.real()) && std::isfinite(variance.imag());
}

/// The variance of an FRF that is not measured.
constexpr double missing = -1.0;

/// Of the square of a value: the variance of what is said to be exact.
constexpr double of_exact = 1e-14;

double variance_of(const Complex& value, const Complex& parts) {
  return is_measured(value, parts) ? std::max(parts.real() + parts.imag(), of_exact * std::norm(value)) : missing;
}

bool depends_on_values(const Variances& variances) {
  return variances.needs_prepare() || std::ranges::any_of(variances.origins(), [](const FileVariances& file) {
           return file.origin == VarianceOrigin::noise_model;
         });
}

/// Motions that the conditions of a member take beside its own.
std::vector<std::size_t> motions_across(const PartGroup& group, const GroupMember& member) {
  std::set<std::size_t> motions;
  const auto take = [&](std::size_t row, std::size_t column) {
    if (std::ranges::find(member.forces, row) != member.forces.end()) motions.insert(column);
  };
  for (const restrictions::MatrixTerms& matrix : group.matrices) {
    for (const restrictions::Term& term : matrix.terms) take(term.row, term.column);
    for (const restrictions::Known& known : matrix.known) take(known.row, known.column);
  }
  return {motions.begin(), motions.end()};
}

using Flags = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Whether all FRFs of the conditions of a member are measured, and the equations take them.
void mark_conditions(const PartGroups& all, const PartGroup& group, std::size_t s, GroupLine& to) {
  const GroupMember& member = group.members[s];
  const Flags motion = to.variance.motion.array() >= 0.0, part = to.variance.parts[s].array() >= 0.0;
  const std::vector<std::size_t> across = motions_across(group, member);
  for (Eigen::Index l = 0; l < motion.cols(); ++l) {
    const bool moves = std::ranges::all_of(across, [&](std::size_t m) { return motion(at(m), l); });
    const std::size_t column_class = all.at_joint[static_cast<std::size_t>(l)] ? 1 : 0;
    for (std::size_t m = 0; m < member.rows.size(); ++m) {
      bool is_there = moves && motion(at(member.motions[m]), l) && part.row(at(m)).head(at(member.forces.size())).all() &&
                      all.wanted[member.at_joint[m] ? 1 : 0][column_class];
      for (const auto& [reference, column] : member.references) is_there = is_there && (at(reference) != l || part(at(m), at(column)));
      to.active(at(member.first_row + m), l) = is_there;
    }
  }
}

void clear_missing(Eigen::MatrixXcd& values, Eigen::MatrixXd& variances) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (variances(i) >= 0.0) continue;
    values(i) = 0.0;
    variances(i) = 0.0;
  }
}

/// A motion that is said to be exact is no more so than arithmetic with those beside it. Small motions far from a shaker keep their errors
/// that are stated.
void limit_exactness(GroupLine& to) {
  constexpr double least = 1e-20, smallest = 1e-300;  // of the mean square of the motions beside
  for (Eigen::Index l = 0; l < to.measured.motion.cols(); ++l) {
    const double floor = least * to.measured.motion.col(l).squaredNorm() / static_cast<double>(to.measured.motion.rows());
    for (Eigen::Index m = 0; m < to.measured.motion.rows(); ++m) {
      double& variance = to.variance.motion(m, l);
      if (variance <= of_exact * std::norm(to.measured.motion(m, l))) variance = std::max({variance, floor, smallest});
    }
  }
}

/// Which conditions are there; values that are not measured get 0, so that nothing is made of them.
void finish(const PartGroups& all, const PartGroup& group, GroupLine& to) {
  to.active.setConstant(at(group.rows), to.measured.motion.cols(), false);
  for (std::size_t s = 0; s < group.members.size(); ++s) mark_conditions(all, group, s, to);
  clear_missing(to.measured.motion, to.variance.motion);
  for (std::size_t s = 0; s < group.members.size(); ++s) clear_missing(to.measured.parts[s], to.variance.parts[s]);
  limit_exactness(to);
  to.current = to.measured;
}

}  // namespace

PartsData::PartsData(const Plan& plan, const PartGroups& all) : all_(all) {
  plan_lines(plan);
  const auto source = [&](frf::FrfSystem& system, const Dofs& rows, const Dofs& columns, std::size_t group, std::size_t member) {
    return Source{std::make_unique<frf::BlockReader>(system, rows, columns),
                  std::make_unique<Variances>(system, rows, columns, plan.scene), group, member};
  };
  assembly_ = source(*plan.assembly, all.motions, all.references, 0, 0);
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    const PartGroup& group = all.groups[g];
    for (std::size_t s = 0; s < group.members.size(); ++s)
      parts_.push_back(source(*plan.substructures, group.members[s].rows, group.members[s].columns, g, s));
    std::vector<std::size_t>& places = motion_places_.emplace_back();
    for (const frf::Dof& dof : group.motions) places.push_back(frf::find_coordinate(all.motions, dof));
  }
}

void PartsData::plan_lines(const Plan& plan) {
  std::vector<std::vector<std::size_t>> at_line;
  for (const Line& line : plan.lines) {
    std::vector<std::size_t> columns = plan.columns->at(line.frequency_hz);
    if (columns.empty()) continue;
    at_line.push_back(std::move(columns));
    frequency_hz_.push_back(line.frequency_hz);
    substructure_lines_.push_back(line.substructures);
    assembly_lines_.push_back(line.assembly);
  }
  for (const PartGroup& group : all_.groups) {
    std::set<std::size_t> own;
    for (const auto& columns : at_line) {
      for (const std::size_t unknown : group.unknowns) own.insert(columns[unknown]);
    }
    const std::vector<std::size_t>& sorted = columns_.emplace_back(own.begin(), own.end());
    auto& places = places_.emplace_back();
    for (const auto& columns : at_line) {
      std::vector<std::size_t>& to = places.emplace_back();
      for (const std::size_t unknown : group.unknowns)
        to.push_back(static_cast<std::size_t>(std::ranges::lower_bound(sorted, columns[unknown]) - sorted.begin()));
    }
  }
}

void PartsData::prepare() {
  if (assembly_.variances->needs_prepare()) assembly_.variances->prepare(assembly_lines_);
  for (Source& part : parts_) {
    if (part.variances->needs_prepare()) part.variances->prepare(substructure_lines_);
  }
}

void PartsData::read(const Control& control) {
  prepare();
  lines_.clear();
  for (std::size_t g = 0; g < all_.groups.size(); ++g) {
    const PartGroup& group = all_.groups[g];
    std::vector<GroupLine>& lines = lines_.emplace_back(frequency_hz_.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines[i].omega = angular(frequency_hz_[i]);
      lines[i].line = i;
      lines[i].columns = places_[g][i];
      lines[i].measured.parts.resize(group.members.size());
      lines[i].variance.parts.resize(group.members.size());
    }
  }
  for (std::size_t i = 0; i < frequency_hz_.size(); ++i) {
    stop_if(control.interrupted);
    if (control.progress) control.progress("reading", i, frequency_hz_.size());
    read_line(i);
  }
}

void PartsData::read_line(std::size_t line) {
  std::vector<Complex> values, variances;
  const auto get = [&](Source& source, std::size_t of) {
    values.resize(source.size());
    variances.resize(source.size());
    source.reader->read(std::array{of}, values);
    source.variances->read(std::array{of}, values, variances);
  };
  get(assembly_, assembly_lines_[line]);
  take_motion(line, values, variances);
  for (Source& part : parts_) {
    get(part, substructure_lines_[line]);
    take_part(part, line, values, variances);
  }
  for (std::size_t g = 0; g < lines_.size(); ++g) finish(all_, all_.groups[g], lines_[g][line]);
}

void PartsData::take_motion(std::size_t line, std::span<const Complex> values, std::span<const Complex> variances) {
  const std::size_t references = all_.references.size();
  for (std::size_t g = 0; g < lines_.size(); ++g) {
    GroupLine& to = lines_[g][line];
    const std::vector<std::size_t>& places = motion_places_[g];
    to.measured.motion.resize(at(places.size()), at(references));
    to.variance.motion.resize(at(places.size()), at(references));
    for (std::size_t m = 0; m < places.size(); ++m) {
      for (std::size_t l = 0; l < references; ++l) {
        const std::size_t from = places[m] * references + l;
        to.measured.motion(at(m), at(l)) = values[from];
        to.variance.motion(at(m), at(l)) = variance_of(values[from], variances[from]);
      }
    }
  }
}

void PartsData::take_part(const Source& source, std::size_t line, std::span<const Complex> values, std::span<const Complex> variances) {
  GroupLine& to = lines_[source.group][line];
  const std::size_t rows = source.reader->rows(), columns = source.reader->columns();
  Eigen::MatrixXcd& h = to.measured.parts[source.member];
  Eigen::MatrixXd& variance = to.variance.parts[source.member];
  h.resize(at(rows), at(columns));
  variance.resize(at(rows), at(columns));
  for (std::size_t i = 0; i < values.size(); ++i) {
    h(at(i / columns), at(i % columns)) = values[i];
    variance(at(i / columns), at(i % columns)) = variance_of(values[i], variances[i]);
  }
}

/// The mean of what groups make of a motion; NaN where it is not measured.
std::vector<Complex> PartsData::corrected_motion(std::size_t line) const {
  const std::size_t references = all_.references.size();
  std::vector<Complex> sum(all_.motions.size() * references, Complex(0.0));
  std::vector<double> count(sum.size(), 0.0);
  for (std::size_t g = 0; g < lines_.size(); ++g) {
    const GroupLine& from = lines_[g][line];
    for (std::size_t m = 0; m < motion_places_[g].size(); ++m) {
      for (std::size_t l = 0; l < references; ++l) {
        const std::size_t to = motion_places_[g][m] * references + l;
        sum[to] += from.current.motion(at(m), at(l));
        count[to] += 1.0;
      }
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(1.0, count[i]);
  return sum;
}

void PartsData::reweigh_motion(std::size_t line) {
  const std::size_t references = all_.references.size();
  const std::vector<Complex> values = corrected_motion(line);
  std::vector<Complex> variances(values.size());
  assembly_.variances->read(std::array{assembly_lines_[line]}, values, variances);
  for (std::size_t g = 0; g < lines_.size(); ++g) {
    Eigen::MatrixXd& to = lines_[g][line].variance.motion;
    for (std::size_t m = 0; m < motion_places_[g].size(); ++m) {
      for (std::size_t l = 0; l < references; ++l) {
        const std::size_t from = motion_places_[g][m] * references + l;
        const double variance = variance_of(values[from], variances[from]);
        if (variance > 0.0) to(at(m), at(l)) = variance;
      }
    }
  }
}

void PartsData::reweigh_part(Source& part, std::size_t line) {
  GroupLine& to = lines_[part.group][line];
  const Eigen::MatrixXcd& h = to.current.parts[part.member];
  const std::size_t columns = part.reader->columns();
  std::vector<Complex> values(part.size()), variances(part.size());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = h(at(k / columns), at(k % columns));
  part.variances->read(std::array{substructure_lines_[line]}, values, variances);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double variance = variance_of(values[k], variances[k]);
    if (variance > 0.0) to.variance.parts[part.member](at(k / columns), at(k % columns)) = variance;
  }
}

bool PartsData::reweigh() {
  bool any = false;
  const bool motion = depends_on_values(*assembly_.variances);
  for (std::size_t i = 0; motion && i < frequency_hz_.size(); ++i) reweigh_motion(i);
  for (Source& part : parts_) {
    if (!depends_on_values(*part.variances)) continue;
    any = true;
    for (std::size_t i = 0; i < frequency_hz_.size(); ++i) reweigh_part(part, i);
  }
  return any || motion;
}

std::vector<FileVariances> PartsData::origins() const {
  std::vector<FileVariances> out;
  for (const Source& part : parts_) {
    for (FileVariances& file : part.variances->origins()) out.push_back(std::move(file));
  }
  for (FileVariances& file : assembly_.variances->origins()) out.push_back(std::move(file));
  return out;
}

std::size_t PartsData::entries_per_line() const {
  std::size_t entries = assembly_.size();
  for (const Source& part : parts_) entries += part.size();
  return entries;
}

std::size_t PartsData::bytes() const {
  std::size_t numbers = 0;
  for (const auto& lines : lines_) {
    for (const GroupLine& line : lines) {
      numbers += 5 * static_cast<std::size_t>(line.measured.motion.size());
      for (const Eigen::MatrixXcd& part : line.measured.parts) numbers += 5 * static_cast<std::size_t>(part.size());
    }
  }
  return numbers * sizeof(double);
}

}  // namespace jointid::ident
