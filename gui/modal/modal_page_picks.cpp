#include <QKeyEvent>
#include <QTabWidget>

#include "gui/modal/modal_page.hpp"
#include "gui/page/job_line.hpp"
#include "gui/plot/chart.hpp"
#include "gui/table/cell_table.hpp"
#include "report/modalfit/stabilisation.hpp"

/// Poles taken and left.
namespace jointid::gui {

void ModalPage::pick(std::vector<modalfit::Pole> poles) {
  if (!sought_) return;
  picked_.pick(std::move(poles));
  go();
}

void ModalPage::undo() {
  if (!picked_.can_undo()) return;
  picked_.undo();
  go();
}

void ModalPage::redo() {
  if (!picked_.can_redo()) return;
  picked_.redo();
  go();
}

/// To what is picked now; what the search found is still there.
void ModalPage::go() {
  modalfit::FitOptions options = used_;
  options.poles = picked_.now();
  if (options.poles) return add_job(options);
  line_->cancel();
  const std::size_t number = ++wanted_;
  line_->worker().add([this, number](const Worker::Watch&) -> Worker::Deliver {
    return [this, number] {
      if (number != wanted_) return;
      run_ = sought_;
      show_run();
      show_buttons();
    };
  });
  show_buttons();
}

/// The poles that a pick changes are those refined, or those asked for while something runs.
void ModalPage::toggle(std::size_t group, std::size_t point) {
  if (!run_ || !sought_) return;
  const std::vector<modalfit::Pole> now = is_busy() && picked_.now() ? *picked_.now() : run_->fit.poles();
  const report::Point at = chart_->scatter().groups[group].points[point];
  if (group != report::elsewhere) return pick(without_pole(now, at.x));
  for (const auto& order : sought_->fit.stabilisation) {
    if (static_cast<double>(order.order) != at.y) continue;
    for (const auto& pole : order.poles) {
      if (pole.frequency_hz == at.x) return pick(with_pole(now, used_.kind, pole));
    }
  }
}

void ModalPage::leave_chosen_mode() {
  const QModelIndex row = modes_->currentIndex();
  if (!row.isValid() || !run_) return;
  const int mode = modes_->cells()->data(row.siblingAtColumn(0), Qt::DisplayRole).toInt();
  if (mode < 1 || static_cast<std::size_t>(mode) > run_->fit.modes.size()) return;
  pick(without_pole(run_->fit.poles(), run_->fit.modes[static_cast<std::size_t>(mode) - 1].pole.frequency_hz));
}

/// Undo and redo are of the picks where the page has the focus, not of the scene's text.
bool ModalPage::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void ModalPage::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Undo)) return undo();
  if (event->matches(QKeySequence::Redo)) return redo();
  if (event->key() == Qt::Key_Delete && results_->currentWidget() == modes_) return leave_chosen_mode();
  QWidget::keyPressEvent(event);
}

}  // namespace jointid::gui
