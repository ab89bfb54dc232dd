#include "gui/solve/joint_tab.hpp"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/look/named.hpp"
#include "gui/solve/solution_tables.hpp"
#include "gui/table/cell_table.hpp"

namespace jointid::gui {

JointTab::JointTab(QWidget* parent) : QWidget(parent) {
  choice_ = named(new QComboBox, "matrix_choice", tr("Matrix and band"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  matrix_ = new CellTable("matrix", tr("Joint matrix"));
  auto* legend = named(new QLabel(tr("± is 95 %, of linear methods their error. Blue is positive, orange negative, "
                                     "blank is zero and no unknown.")),
                       "matrix_legend", tr("How to read the matrix"));
  legend->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(choice_, 0, Qt::AlignLeft);
  column->addWidget(matrix_, 1);
  column->addWidget(legend);
  connect(choice_, &QComboBox::currentIndexChanged, this, &JointTab::show_matrix);
}

void JointTab::show_run(const Solved& run) {
  solution_ = run.solution;
  const QSignalBlocker quiet(choice_);
  const int before = choice_->currentIndex();
  choice_->clear();
  for (std::size_t band = 0; band < solution_.bands.size(); ++band) {
    const auto& each = solution_.bands[band];
    for (const auto& [kind, matrix] : each.matrices) {
      QString text = QString::fromStdString(restrictions::key(kind)).replace('_', ' ') + tr(" (SI)");
      if (each.band_hz) text += tr(", %1 to %2 Hz").arg((*each.band_hz)[0]).arg((*each.band_hz)[1]);
      choice_->addItem(text, QVariantList{static_cast<qulonglong>(band), static_cast<int>(kind)});
    }
  }
  choice_->setCurrentIndex(before >= 0 && before < choice_->count() ? before : 0);
  show_matrix();
}

void JointTab::show_element(const tasks::MatrixElement& element) {
  const QVariantList wanted{static_cast<qulonglong>(element.band), static_cast<int>(element.kind)};
  choice_->setCurrentIndex(choice_->findData(wanted));
  const QModelIndex cell = matrix_->cells()->index(static_cast<int>(element.row), static_cast<int>(element.column));
  matrix_->setCurrentIndex(cell);
  matrix_->scrollTo(cell);
}

void JointTab::show_matrix() {
  const QVariantList choice = choice_->currentData().toList();
  if (choice.size() != 2) return matrix_->show_rows({});
  matrix_->show_rows(matrix_rows(solution_, choice[0].toULongLong(), static_cast<restrictions::Kind>(choice[1].toInt())));
}

}  // namespace jointid::gui
