#include "report/text/dof_list.hpp"

namespace jointid::report {

std::string dof_list(const std::vector<frf::Dof>& dofs) {
  constexpr std::size_t shown = 12;
  std::string text = std::to_string(dofs.size()) + (dofs.empty() ? "" : ":");
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    if (dofs.size() <= shown || i < shown - 1 || i + 1 == dofs.size()) text += " " + dofs[i].name();
    if (dofs.size() > shown && i == shown - 1) text += " …";
  }
  return text;
}

}  // namespace jointid::report
