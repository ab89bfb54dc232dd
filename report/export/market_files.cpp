#include <fmt/format.h>

#include "report/export/export_parts.hpp"

namespace jointid::report {
namespace {

std::string market_text(const ExportedMatrices& of, Kind kind) {
  const bool symmetric = of.is_symmetric(kind);
  std::string text = fmt::format("%%MatrixMarket matrix coordinate real {}\n", symmetric ? "symmetric" : "general");
  for (const std::string& line : of.head()) text += "% " + line + "\n";
  std::string rows;
  std::size_t count = 0;
  for (std::size_t j = 0; j < of.size(); ++j) {
    for (std::size_t i = symmetric ? j : 0; i < of.size(); ++i) {
      const double value = of.at(kind, i, j).value;
      if (value == 0.0) continue;
      text += fmt::format("% {} {}: {}\n", i + 1, j + 1, of.remark(kind, i, j));
      rows += fmt::format("{} {} {:.17g}\n", i + 1, j + 1, value);
      ++count;
    }
  }
  return text + fmt::format("{0} {0} {1}\n", of.size(), count) + rows;
}

}  // namespace

std::vector<ExportFile> market_files(const ExportedMatrices& of, ExportWay way) {
  if (way != ExportWay::matrix) of.refuse("Matrix Market holds matrices, no springs", "leave out --as");
  std::vector<ExportFile> files;
  for (const Kind kind : restrictions::all_kinds) {
    if (of.has(kind)) files.push_back({"_" + restrictions::symbol(kind) + ".mtx", market_text(of, kind)});
  }
  std::string labels = "# jointid: DOFs of the rows\n";
  for (const frf::Dof& dof : of.dofs()) labels += dof.name() + "\n";
  files.push_back({"_dofs.txt", labels});
  return files;
}

}  // namespace jointid::report
