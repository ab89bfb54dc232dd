#include "gui/page/dof_box.hpp"

#include <QComboBox>
#include <algorithm>

#include "gui/look/said.hpp"

namespace jointid::gui {

void fill_dofs(QComboBox& box, const std::vector<frf::Dof>& dofs) {
  const QString before = box.currentText();
  box.clear();
  for (const frf::Dof& dof : dofs) box.addItem(q(dof.name()));
  box.setCurrentIndex(std::max(0, box.findText(before)));
}

}  // namespace jointid::gui
