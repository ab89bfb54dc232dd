#include "gui/solve/frf_tab.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "base/text.hpp"
#include "gui/look/named.hpp"
#include "gui/page/dof_box.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/solve/kept_runs.hpp"

namespace jointid::gui {
namespace {

/// A kept run whose files are gone stays without a plan.
Solved with_plan(Solved run) {
  try {
    if (run.plan == nullptr && !run.scene_text.empty()) make_plan_of(run);
  } catch (const InputError&) {
    run.plan = nullptr;
  }
  return run;
}

}  // namespace

FrfTab::FrfTab(Worker& worker, QWidget* parent) : QWidget(parent), worker_(worker) {
  response_ = named(new QComboBox, "asm_response", tr("Response"));
  reference_ = named(new QComboBox, "asm_reference", tr("Reference"));
  all_runs_ = named(new QCheckBox(tr("all runs")), "all_runs", tr("Draw the synthesised FRFs of all runs"),
                    tr("Draw the FRFs synthesised with the joint of every run of the session"));
  error_db_ = named(new QLabel, "error_db", tr("Error of the synthesised FRF"));
  plot_ = new FrfPlot(tr("After solving, this tab shows the FRFs of the assembly, measured and synthesised with the joint."));
  plot_->offer(View::difference);
  auto* row = new QHBoxLayout;
  for (QWidget* each : std::initializer_list<QWidget*>{response_, reference_, all_runs_, error_db_}) row->addWidget(each);
  row->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row);
  column->addWidget(plot_, 1);
  for (QComboBox* each : {response_, reference_}) connect(each, &QComboBox::activated, this, &FrfTab::show_frf);
  connect(all_runs_, &QCheckBox::toggled, this, &FrfTab::show_frf);
  connect(plot_, &FrfPlot::next_wanted, this, &FrfTab::show_next);
}

/// Reference by reference.
void FrfTab::show_next(int step) {
  const int columns = reference_->count(), all = columns * response_->count();
  if (all == 0) return;
  const int next = std::clamp(response_->currentIndex() * columns + reference_->currentIndex() + step, 0, all - 1);
  response_->setCurrentIndex(next / columns);
  reference_->setCurrentIndex(next % columns);
  show_frf();
}

void FrfTab::show_runs(const std::vector<Solved>& runs, std::size_t front) {
  runs_ = runs;
  front_ = front;
  if (runs_[front_].plan == nullptr) return clear();
  fill_dofs(*response_, tasks::regenerable_responses(*runs_[front_].plan));
  fill_dofs(*reference_, tasks::regenerable_references(*runs_[front_].plan));
  plot_->set_marked(outlying_hz(runs_[front_]));
  show_frf();
}

/// Of a kept run, until its plan is made.
void FrfTab::clear() {
  runs_.clear();
  ++wanted_;
  response_->clear();
  reference_->clear();
  error_db_->clear();
  plot_->set_marked({});
  plot_->set_curves({});
}

void FrfTab::show_error(const tasks::FrfEntry& entry) {
  response_->setCurrentText(QString::fromStdString(entry.response.name()));
  reference_->setCurrentText(QString::fromStdString(entry.reference.name()));
  plot_->set_view(View::difference);
  show_frf();
}

void FrfTab::show_frf() {
  if (runs_.empty() || runs_[front_].solution.bands.empty()) return;
  if (response_->count() == 0 || reference_->count() == 0) return;
  const tasks::FrfEntry entry{frf::Dof::parse(response_->currentText().toStdString()),
                              frf::Dof::parse(reference_->currentText().toStdString())};
  std::vector<Solved> others;
  for (std::size_t i = 0; i < runs_.size() && all_runs_->isChecked(); ++i) {
    if (i != front_) others.push_back(runs_[i]);
  }
  const std::size_t number = ++wanted_;
  worker_.add([this, front = runs_[front_], others, entry, number](const Worker::Watch& watch) -> Worker::Deliver {
    Overlay overlay = regenerate_frf(front, entry, watch);
    for (const Solved& other : others) add_regenerated(overlay, with_plan(other), entry, watch);
    return [this, number, overlay] {
      if (number == wanted_) show_overlay(overlay);
    };
  });
}

void FrfTab::show_overlay(const Overlay& overlay) {
  plot_->set_curves(overlay.curves);
  QString text = overlay.error_db ? tr("error %1 dB (rms)").arg(QString::fromStdString(digits(*overlay.error_db, "%.3g")))
                                  : tr("not comparable");
  const int marked = static_cast<int>(outlying_hz(runs_[front_]).size());
  if (marked > 0) text += tr("; %n outlier line(s), red below the curves", nullptr, marked);
  error_db_->setText(text);
}

}  // namespace jointid::gui
