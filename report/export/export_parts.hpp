#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/export/export_options.hpp"
#include "tasks/export/joint_for_others.hpp"

namespace jointid::report {

using restrictions::Kind;

/// X(row, column) with its standard error (NaN: not known).
struct CardValue {
  double value = 0.0, error = 0.0;
};

/// A spring, damper or mass between two DOFs (places in the joint), or one and the ground: X = Σ y b bᵀ, b = e_first − e_second.
struct Link {
  std::size_t first = 0;
  std::optional<std::size_t> second;
  std::map<Kind, CardValue> by_kind;  ///< those that are not 0

  CardValue of(Kind kind) const { return by_kind.contains(kind) ? by_kind.at(kind) : CardValue{}; }
  bool has(Kind kind) const { return by_kind.contains(kind); }
};

/// What the writers of all programs share: the joint in the units of the file.
class ExportedMatrices {
 public:
  ExportedMatrices(const tasks::ExportedJoint& joint, const ExportOptions& options);

  const std::vector<frf::Dof>& dofs() const { return joint_.dofs; }
  std::size_t size() const { return joint_.dofs.size(); }
  bool has(Kind kind) const { return joint_.matrices.contains(kind); }  ///< and it is not all zeros
  CardValue at(Kind kind, std::size_t row, std::size_t column) const;
  bool is_symmetric(Kind kind) const;
  bool is_symmetric() const;

  /// Symmetric matrices as links, first < second, the ground last; what is rounding of a sum of elements is left out.
  std::vector<Link> links() const;

  /// "K(4:+Y,5:+Y) = -1.2e+06 N/m, standard error 3.4e+04".
  std::string remark(Kind kind, std::size_t row, std::size_t column) const;
  std::string remark(Kind kind, const Link& link) const;

  /// First lines of every file, each to be made a comment.
  std::vector<std::string> head() const;

  const ExportOptions& options() const { return options_; }
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const;

 private:
  std::string unit(Kind kind, std::size_t row, std::size_t column) const;
  std::string value_text(Kind kind, const CardValue& value, std::size_t row, std::size_t column) const;

  tasks::ExportedJoint joint_;
  ExportOptions options_;
};

/// Whether springs and dampers that are not negative, between DOFs of one direction, are the whole joint.
bool consists_of_springs(const ExportedMatrices& of);

/// Links of each pair of nodes (or node and ground), by direction, from 1; every link must join DOFs of one direction and have no
/// mass.
struct Bush {
  std::int64_t first = 0;
  std::optional<std::int64_t> second;
  std::map<int, Link> by_direction;
};
std::vector<Bush> bushes(const ExportedMatrices& of);

/// "1" to "6".
int component(const frf::Dof& dof);

/// Sixteen characters at most, with as many digits as fit: "-1.2345678901+6".
std::string sixteen(double value);

std::vector<ExportFile> nastran_files(const ExportedMatrices& of, ExportWay way);
std::vector<ExportFile> ansys_files(const ExportedMatrices& of, ExportWay way);
std::vector<ExportFile> abaqus_files(const ExportedMatrices& of, ExportWay way);
std::vector<ExportFile> market_files(const ExportedMatrices& of, ExportWay way);

}  // namespace jointid::report
