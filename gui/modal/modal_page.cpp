#include "gui/modal/modal_page.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>
#include <limits>

#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/look/scrolled.hpp"
#include "gui/modal/modal_tables.hpp"
#include "gui/page/dof_box.hpp"
#include "gui/page/job_line.hpp"
#include "gui/plot/chart.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/plot/heat_chart.hpp"
#include "gui/table/cell_table.hpp"
#include "report/modalfit/modal_text.hpp"
#include "report/modalfit/stabilisation.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_lines_behind = 2000;

}  // namespace

ModalPage::ModalPage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Modes"));
  line_ = new JobLine("modal", tr("Status of the modal fit"), tr("Stop and keep the modes found so far"));
  chart_ = new Chart("stabilisation", tr("Stabilisation diagram"),
                     tr("Find modes shows the poles of all orders here.\nClick a pole to take it as a mode, or a pole of a mode "
                        "to remove it; Ctrl+Z undoes.\n← and → go from pole to pole, Enter is a click; wheel, + and − zoom."));
  chart_->let_zoom();
  auto* both = named(new QSplitter(Qt::Vertical), "diagram_and_modes", tr("Diagram and modes"));
  both->addWidget(chart_);
  both->addWidget(make_results());
  both->setSizes({380, 300});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  all->addWidget(line_);
  all->addWidget(scrolled(both), 1);
  connect_all();
  set_scene({});
}

QWidget* ModalPage::make_top() {
  auto* top = named(new QWidget, "modal_top", tr("Fitting modes"));
  find_ = push_button("modal_find", tr("Find modes"), tr("Find all modes above the noise"));
  structure_ = named(new QComboBox, "modal_structure", tr("Substructure or assembly"));
  structure_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  low_ = frequency_box("modal_low", tr("Lowest frequency"), tr("from"));
  high_ = frequency_box("modal_high", tr("Highest frequency"), tr("to"));
  damping_ = named(new QComboBox, "modal_damping", tr("Damping"), tr("Damping model of the modes"));
  for (const auto damping : {modalfit::Damping::viscous, modalfit::Damping::hysteretic})
    damping_->addItem(q(modalfit::name(damping)));
  real_ = named(new QCheckBox(tr("real modes")), "modal_real", tr("Real modes"), tr("All DOFs move in phase or in antiphase"));
  undo_ = push_button("modal_undo", tr("Undo"), tr("Undo the last pick (Ctrl+Z in the diagram)"));
  redo_ = push_button("modal_redo", tr("Redo"), tr("Pick again (Ctrl+Shift+Z in the diagram)"));
  none_ = push_button("modal_none", tr("None"), tr("Remove all modes, to pick poles one by one"));
  command_ = push_button("modal_command", tr("Copy as command"), tr("Copy the command line with the same modes"));
  shapes_ = push_button("modal_shapes", tr("Shapes…"), tr("Write the mode shapes as `jointid modalfit --shapes` does (UFF 55)"));
  regenerated_ =
      push_button("modal_regenerated", tr("FRFs…"), tr("Write the synthesised FRFs as `jointid modalfit --regenerate` does"));
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({find_, line_->cancel_button(), structure_, low_, high_}, {}));
  rows->addLayout(row_of({damping_, real_, undo_, redo_, none_}, {shapes_, regenerated_, command_}));
  return top;
}

QWidget* ModalPage::make_results() {
  modes_ = new CellTable("modes", tr("Modes with standard errors. Delete removes one"));
  modes_->setSelectionBehavior(QAbstractItemView::SelectRows);
  mac_ = new CellTable("mac", tr("MAC of all modes"));
  errors_ = new CellTable("synthesis_errors", tr("Error of all FRFs in dB, without antiresonances"));
  results_ = named(new QTabWidget, "modal_results", tr("Modes and FRFs"));
  results_->addTab(make_frf_tab(), tr("FRFs"));
  results_->addTab(modes_, tr("Modes"));
  results_->addTab(mac_, tr("MAC"));
  results_->addTab(make_cross_tab(), tr("Other modes"));
  results_->addTab(errors_, tr("Errors"));
  return results_;
}

QWidget* ModalPage::make_frf_tab() {
  auto* tab = named(new QWidget, "modal_frfs", tr("Measured and synthesised FRFs"));
  response_ = named(new QComboBox, "modal_response", tr("Response"));
  reference_ = named(new QComboBox, "modal_reference", tr("Reference"));
  for (QComboBox* box : {response_, reference_}) box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  plot_ =
      new FrfPlot(tr("Find modes draws the FRFs synthesised from the modes over the measured ones. Every pick updates them."));
  plot_->offer(View::difference);
  auto* column = new QVBoxLayout(tab);
  column->setContentsMargins(0, 4, 0, 0);
  column->addLayout(row_of({response_, reference_}, {}));
  column->addWidget(plot_, 1);
  return tab;
}

QWidget* ModalPage::make_cross_tab() {
  auto* tab = named(new QWidget, "cross_mac_tab", tr("MAC with other modes"));
  auto* choose =
      push_button("cross_mac_choose", tr("Compare with…"),
                  tr("Other modes, of another test or of a model: a universal file (UFF 55), or JSON of jointid modalfit"));
  cross_word_ = named(new QLabel, "cross_mac_word", tr("About the pairs of modes"));
  cross_word_->setWordWrap(true);
  cross_word_->setTextFormat(Qt::PlainText);
  cross_mac_ = new HeatChart("cross_mac", tr("MAC of the modes found with other modes"),
                             tr("Compare with… draws the MAC of the modes found with those of a file."));
  auto* column = new QVBoxLayout(tab);
  column->setContentsMargins(0, 4, 0, 0);
  column->addLayout(row_of({choose}, {}));
  column->addWidget(cross_word_);
  column->addWidget(cross_mac_, 1);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QStringList files = choose_modes_to_open(this);
    if (!files.isEmpty()) compare_with(files.front());
  });
  return tab;
}

void ModalPage::connect_all() {
  connect(line_, &JobLine::failed, this, &ModalPage::failed);
  connect(line_, &JobLine::busy_changed, this, &ModalPage::show_buttons);
  for (QComboBox* box : {response_, reference_}) connect(box, &QComboBox::activated, this, &ModalPage::show_frf);
  connect(find_, &QPushButton::clicked, this, &ModalPage::run);
  connect(undo_, &QPushButton::clicked, this, &ModalPage::undo);
  connect(redo_, &QPushButton::clicked, this, &ModalPage::redo);
  connect(none_, &QPushButton::clicked, this, [this] { pick({}); });
  connect(command_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  connect(chart_, &Chart::opened, this, &ModalPage::toggle);
  connect(shapes_, &QPushButton::clicked, this, [this] {
    const QString file = choose_file_to_save(this, tr("Write the mode shapes"), QStringLiteral("shapes.uff"),
                                             tr("Universal files (*.uff)"), QStringLiteral("uff"));
    if (!file.isEmpty()) write_shapes(file);
  });
  connect(regenerated_, &QPushButton::clicked, this, [this] {
    const QString file = choose_file_to_save(this, tr("Write the synthesised FRFs"), QStringLiteral("synthesised.h5"),
                                             tr("FRFs (*.h5 *.uff *.mat *.csv)"), QStringLiteral("h5"));
    if (!file.isEmpty()) write_regenerated(file);
  });
}

bool ModalPage::is_busy() const { return line_->is_busy(); }

QString ModalPage::status() const { return line_->status(); }

void ModalPage::cancel() { line_->cancel(); }

/// The structure that was chosen stays, if it is still there.
void ModalPage::set_scene(const std::optional<ident::Scene>& scene) {
  if (scene) {
    const QString before = structure_->currentText();
    structures_ = structures_of(scene->data);
    structure_->clear();
    for (const ModalStructure& each : structures_) structure_->addItem(q(each.name));
    structure_->setCurrentIndex(std::max(0, structure_->findText(before)));
    if (const auto range = scene->frequency.range_hz; range && low_->value() == 0.0 && high_->value() == 0.0) {
      low_->setValue((*range)[0]);
      high_->setValue((*range)[1]);
    }
  }
  show_buttons();
}

const ModalStructure* ModalPage::structure() const {
  const int chosen = structure_->currentIndex();
  return chosen < 0 ? nullptr : &structures_[static_cast<std::size_t>(chosen)];
}

modalfit::FitOptions ModalPage::options() const {
  modalfit::FitOptions out;
  out.kind = {damping_->currentIndex() == 1 ? modalfit::Damping::hysteretic : modalfit::Damping::viscous, real_->isChecked()};
  const double high = high_->value() > 0.0 ? high_->value() : std::numeric_limits<double>::max();
  if (low_->value() > 0.0 || high_->value() > 0.0) out.range_hz = {low_->value(), high};
  return out;
}

void ModalPage::run() {
  if (structure() == nullptr) return;
  of_run_ = *structure();
  used_ = options();
  loaded_.reset();
  run_.reset();
  sought_.reset();
  picked_.begin();
  chart_->clear();
  line_->say(tr("Finding modes …"));
  add_job(used_);
}

/// Only the last that was asked for is shown.
void ModalPage::add_job(const modalfit::FitOptions& options) {
  line_->cancel();
  const std::size_t number = ++wanted_;
  const ModalWish wish{of_run_, options, loaded_};
  line_->worker().add([this, number, wish](const Worker::Watch& watch) -> Worker::Deliver {
    return [this, number, wish, found = run_modal_job(wish, watch)] {
      if (number != wanted_) return;
      loaded_ = found.loaded;
      run_ = found.run;
      if (!wish.options.poles) sought_ = found.run;
      show_run();
      show_buttons();
    };
  });
  show_buttons();
}

void ModalPage::show_run() {
  chart_->draw(report::stabilisation_diagram(*run_, sought_->fit.stabilisation, most_lines_behind));
  modes_->show_rows(rows_of(report::modes_table(*run_)));
  mac_->show_rows(mac_rows(*run_));
  errors_->show_rows(synthesis_rows(*run_));
  fill_dofs(*response_, run_->fit.response);
  fill_dofs(*reference_, run_->fit.reference);
  show_frf();
  show_cross_mac();
  QString text = tr("%n mode(s); %1", nullptr, static_cast<int>(run_->fit.modes_inside()))
                     .arg(q(report::synthesis_text(run_->symmetric ? run_->of_model : run_->of_fit)));
  for (const std::string& note : report::notes(*run_)) text += "\n" + q(note);
  line_->say(text, !is_usable(run_->fit.status));
  Q_EMIT modes_changed();
}

void ModalPage::show_frf() {
  if (!run_ || response_->currentIndex() < 0 || reference_->currentIndex() < 0) return;
  plot_->set_curves(synthesised(*run_, static_cast<std::size_t>(response_->currentIndex()),
                                static_cast<std::size_t>(reference_->currentIndex())));
}

void ModalPage::show_buttons() {
  find_->setEnabled(structure() != nullptr && !is_busy());
  undo_->setEnabled(picked_.can_undo());
  redo_->setEnabled(picked_.can_redo());
  none_->setEnabled(sought_ != nullptr);
  for (QPushButton* button : {shapes_, regenerated_}) button->setEnabled(run_ != nullptr && !is_busy());
  command_->setEnabled(structure() != nullptr && (!picked_.now() || !picked_.now()->empty()));
}

}  // namespace jointid::gui
