#include "gui/solve/difference_tab.hpp"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/table/cell_table.hpp"
#include "tasks/joint/run_difference.hpp"

namespace jointid::gui {
namespace {

Cell value_cell(double value, const std::optional<double>& half) {
  Cell cell{q(digits(value, "%.5g")) + (half ? QStringLiteral(" ± ") + q(digits(*half)) : QString()), q(digits(value, "%.17g"))};
  cell.copied = cell.hint;
  return cell;
}

CellRows difference_rows(const std::vector<tasks::UnknownDifference>& all) {
  CellRows out{{Said::tr("name"), Said::tr("unit"), Said::tr("other run"), Said::tr("this run"), Said::tr("difference"),
                Said::tr("of the other"), Said::tr("differs")},
               {},
               {}};
  for (const tasks::UnknownDifference& each : all) {
    Cell share{std::isfinite(each.relative) ? QStringLiteral("%1%2").arg(each.relative < 0.0 ? QStringLiteral("−") : QStringLiteral("+"),
                                                                         q(percent(std::abs(each.relative))))
                                            : QString()};
    if (each.differs()) share.shade = 0.75 * std::clamp(each.relative, -1.0, 1.0);
    const QString verdict = !each.half ? Said::tr("no intervals") : each.differs() ? Said::tr("yes") : Said::tr("within the intervals");
    out.cells.push_back({Cell{q(each.name)}, Cell{q(each.unit)}, value_cell(each.first, each.first_half),
                         value_cell(each.second, each.second_half), value_cell(each.difference, each.half), share, Cell{verdict}});
  }
  return out;
}

}  // namespace

DifferenceTab::DifferenceTab(QWidget* parent) : QWidget(parent) {
  other_ = named(new QComboBox, "difference_other", tr("The other run"), tr("Runs of this scene, and of the other scenes that are open"));
  other_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  word_ = named(new QLabel, "difference_word", tr("About the differences"));
  word_->setWordWrap(true);
  table_ = new CellTable("differences", tr("Differences of the unknowns"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(other_, 0, Qt::AlignLeft);
  column->addWidget(word_);
  column->addWidget(table_, 1);
  connect(other_, &QComboBox::currentIndexChanged, this, &DifferenceTab::show_differences);
  offer();
}

void DifferenceTab::set_elsewhere(std::function<Others()> elsewhere) { elsewhere_ = std::move(elsewhere); }

void DifferenceTab::show_run(const std::vector<Solved>& runs, std::size_t front) {
  front_ = runs[front].solution.unknowns;
  own_.clear();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i != front) own_.emplace_back(tr("run %1").arg(q(runs[i].name)), runs[i].solution.unknowns);
  }
  offer();
}

void DifferenceTab::clear() {
  front_.clear();
  own_.clear();
  offer();
}

void DifferenceTab::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  offer();
}

void DifferenceTab::offer() {
  const QString before = other_->currentText();
  all_ = own_;
  if (elsewhere_) {
    Others more = elsewhere_();
    all_.insert(all_.end(), more.begin(), more.end());
  }
  const QSignalBlocker quiet(other_);
  other_->clear();
  for (const auto& [name, unknowns] : all_) other_->addItem(name);
  other_->setCurrentIndex(all_.empty() ? -1 : std::max(0, other_->findText(before)));
  show_differences();
}

void DifferenceTab::show_differences() {
  const int chosen = other_->currentIndex();
  if (front_.empty() || chosen < 0) {
    word_->setText(tr("Two runs are compared here: solve this scene twice, or solve another scene that is open, of another tightening."));
    return table_->show_rows({});
  }
  const auto all = tasks::run_differences(all_[static_cast<std::size_t>(chosen)].second, front_);
  const auto differing = static_cast<int>(std::ranges::count_if(all, &tasks::UnknownDifference::differs));
  word_->setText(all.empty() ? tr("The two runs have no unknown in common.")
                             : tr("%n unknown(s) differ beyond the intervals of both. ± is 95 %.", nullptr, differing));
  table_->show_rows(difference_rows(all));
}

}  // namespace jointid::gui
