#include "report/export/export_files.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/error.hpp"
#include "report/export/export_parts.hpp"

namespace jointid::report {
namespace {

const std::vector<std::string> target_words = {"nastran", "ansys", "abaqus", "matrix-market"};
const std::vector<std::string> way_words = {"auto", "springs", "bush", "matrix"};

/// Titles are names of unknowns, which have commas.
std::string quoted(const std::string& name) { return "\"" + name + "\""; }

/// Covariance of the unknowns, SI units.
std::string covariance_csv(const tasks::ExportedJoint& joint) {
  std::string text = "# jointid covariance of the unknowns of " + joint.source +
                     ", SI units; empty: not known\nunknown,unit,value,standard error";
  for (const ident::Estimate& unknown : joint.unknowns) text += "," + quoted(unknown.name);
  text += "\n";
  const auto cell = [](double value) { return std::isfinite(value) ? fmt::format("{:.17g}", value) : std::string(); };
  for (std::size_t i = 0; i < joint.unknowns.size(); ++i) {
    const ident::Estimate& unknown = joint.unknowns[i];
    text += fmt::format("{},{},{},{}", quoted(unknown.name), unknown.unit, cell(unknown.value),
                        unknown.error() ? cell(*unknown.error()) : "");
    for (const double value : joint.covariance[i]) text += "," + cell(value);
    text += "\n";
  }
  return text;
}

}  // namespace

ExportTarget parse_export_target(const std::string& word) {
  return static_cast<ExportTarget>(find_word(word, target_words, "program"));
}

ExportWay parse_export_way(const std::string& word) {
  return static_cast<ExportWay>(find_word(word, way_words, "way to write a joint"));
}

std::vector<std::string> export_suffixes(const ExportOptions& options) {
  switch (options.target) {
    case ExportTarget::nastran:
      return {".bdf", "_covariance.csv"};
    case ExportTarget::ansys:
    case ExportTarget::abaqus:
      return {".inp", "_covariance.csv"};
    case ExportTarget::matrix_market:
      break;
  }
  return {"_K.mtx", "_M.mtx", "_C.mtx", "_D.mtx", "_dofs.txt", "_covariance.csv"};
}

std::vector<ExportFile> export_files(const tasks::ExportedJoint& joint, const ExportOptions& options) {
  const ExportedMatrices of(joint, options);
  ExportWay way = options.way;
  if (way == ExportWay::automatic)
    way = options.target != ExportTarget::matrix_market && consists_of_springs(of) ? ExportWay::springs : ExportWay::matrix;
  if (way != ExportWay::matrix && !of.is_symmetric())
    of.refuse("the joint has a matrix that is not symmetric, which springs are not", "write whole matrices: --as matrix");
  using Writer = std::vector<ExportFile> (*)(const ExportedMatrices&, ExportWay);
  constexpr std::array<Writer, 4> writers = {nastran_files, ansys_files, abaqus_files, market_files};
  std::vector<ExportFile> files = writers[static_cast<std::size_t>(options.target)](of, way);
  files.push_back({"_covariance.csv", covariance_csv(joint)});
  return files;
}

}  // namespace jointid::report
