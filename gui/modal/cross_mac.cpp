#include "gui/modal/cross_mac.hpp"

#include "base/text.hpp"
#include "correlation/correlated_modes.hpp"
#include "gui/look/said.hpp"
#include "tasks/correlate/compared_files.hpp"

namespace jointid::gui {
namespace {

std::vector<std::string> names_of(const std::vector<double>& frequency_hz) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < frequency_hz.size(); ++i)
    out.push_back(std::to_string(i + 1) + ": " + digits(frequency_hz[i], "%.5g") + " Hz");
  return out;
}

}  // namespace

CrossMac cross_mac(const tasks::ModalRun& run, const std::filesystem::path& other) {
  const correlation::CorrelatedModes found = correlation::correlate({run.files, tasks::uff_modes(run)}, tasks::read_modes(other));
  CrossMac out;
  out.map = {.x_label = Said::tr("modes of %1").arg(q(other.filename().string())).toStdString(),
             .y_label = Said::tr("modes found").toStdString(),
             .value_label = "MAC",
             .columns = names_of(found.other_hz),
             .x_values = {},
             .rows = names_of(found.one_hz),
             .values = {},
             .from_0_to_1 = true};
  for (Eigen::Index row = 0; row < found.mac.rows(); ++row) {
    for (Eigen::Index column = 0; column < found.mac.cols(); ++column) out.map.values.push_back(found.mac(row, column));
  }
  out.said = Said::tr("%1 of %2 modes have a partner with a MAC of one half at least, over %3 DOFs that both sets have.")
                 .arg(found.pairs())
                 .arg(found.one_hz.size())
                 .arg(found.dofs.size());
  return out;
}

}  // namespace jointid::gui
