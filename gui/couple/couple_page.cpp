#include "gui/couple/couple_page.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFileInfo>
#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/look/scrolled.hpp"
#include "gui/page/job_line.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/scene/completion_place.hpp"
#include "report/couple/couple_plots.hpp"
#include "report/couple/couple_text.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_points = 4000;

report::PlotGroup alphas(const Coupled& coupled) {
  const auto& found = coupled.result.dependencies;
  if (!found)
    return report::alpha_plots(coupled.result.frequency_hz, coupled.result.records, coupled.result.conditions, {}, most_points);
  std::vector<std::string> names;
  for (const coupling::Dependency& condition : found->conditions) names.push_back(condition.condition);
  const auto level = found->threshold > 0.0 ? std::optional(found->threshold) : std::nullopt;
  return report::alpha_plots(coupled.result.frequency_hz, coupled.result.survey, names, level, most_points);
}

}  // namespace

bool is_couple_scene(const std::string& text) { return line_of_key(text, "couple", "") > 0; }

CouplePage::CouplePage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Coupling"));
  line_ = new JobLine("couple", tr("Status of the coupling"), tr("Stop without writing a file"));
  plots_ = new PlotMenu("coupled", tr("Predicted and measured FRFs"),
                        tr("This page shows the FRFs of the assembly, predicted from its substructures and joints.\nIt needs a "
                           "scene with [data] parts and [couple]. Measured FRFs can be drawn over them."));
  auto* both = named(new QSplitter(Qt::Vertical), "coupled_and_tables", tr("Diagram and tables"));
  both->addWidget(plots_);
  both->addWidget(make_tables());
  both->setStretchFactor(0, 1);
  both->setSizes({450, 200});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  all->addWidget(line_);
  all->addWidget(scrolled(both), 1);
  connect(line_, &JobLine::failed, this, &CouplePage::failed);
  connect(line_, &JobLine::busy_changed, this, &CouplePage::show_buttons);
  show_buttons();
}

QWidget* CouplePage::make_top() {
  auto* top = named(new QWidget, "couple_top", tr("Coupling"));
  run_ = push_button("couple", tr("Couple"), tr("Predict the FRFs of the assembly and write them beside the scene"));
  bounds_ = named(new QCheckBox(tr("bounds")), "couple_bounds", tr("Bounds"),
                  tr("Compute without redundant compatibility conditions, and with all of them: the true FRF lies between"));
  auto* measured = push_button("couple_measured", tr("Measured…"), tr("Choose measured FRFs of the assembly for comparison"));
  names_ = named(new QLabel, "couple_names", tr("Measured files"));
  names_->setTextFormat(Qt::PlainText);
  command_ = push_button("couple_command", tr("Copy as command"), tr("Copy the command line that writes the same file"));
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({run_, line_->cancel_button(), bounds_, measured, names_}, {command_}));
  connect(run_, &QPushButton::clicked, this, &CouplePage::run);
  connect(measured, &QPushButton::clicked, this, [this] { set_measured(choose_files_to_open(this)); });
  connect(command_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  return top;
}

QTabWidget* CouplePage::make_tables() {
  resonances_ = new CellTable("couple_resonances", tr("Resonances of the assembly"));
  errors_ = new CellTable("couple_errors", tr("Errors of the predicted FRFs, largest first"));
  conditions_ = new CellTable("couple_conditions", tr("Compatibility conditions, used and left out"));
  tables_ = named(new QTabWidget, "couple_tables", tr("Resonances, errors and compatibility"));
  tables_->addTab(resonances_, tr("Resonances"));
  tables_->addTab(errors_, tr("Errors"));
  tables_->addTab(conditions_, tr("Compatibility"));
  return tables_;
}

bool CouplePage::is_busy() const { return line_->is_busy(); }

QString CouplePage::status() const { return line_->status(); }

void CouplePage::cancel() { line_->cancel(); }

void CouplePage::set_bounds(bool on) { bounds_->setChecked(on); }

void CouplePage::show_buttons() {
  run_->setEnabled(scene_.has_value() && !is_busy());
  command_->setEnabled(scene_.has_value());
}

std::optional<SceneError> CouplePage::set_scene(const std::string& text, const std::filesystem::path& path, const QString& file) {
  scene_.reset();
  file_ = file;
  std::optional<SceneError> wrong;
  if (is_couple_scene(text)) {
    try {
      scene_ = ident::parse_couple_scene(text, path);
    } catch (const InputError& error) {
      wrong = located(error, text);
    }
  }
  show_buttons();
  return wrong;
}

/// What is shown is compared at the next coupling.
void CouplePage::set_measured(const QStringList& files) {
  if (files.isEmpty()) return;
  measured_ = files;
  QStringList names;
  for (const QString& file : measured_) names << QFileInfo(file).fileName();
  names_->setText(names.join(QStringLiteral(", ")));
  if (coupled_ && scene_ && !is_busy()) run();
}

QString CouplePage::result_file() const {
  const QFileInfo scene(file_);
  return scene.absolutePath() + "/" + scene.completeBaseName() + ".coupled.h5";
}

void CouplePage::run() {
  if (!scene_ || is_busy()) return;
  if (file_.isEmpty()) return line_->say(tr("Save the scene first. The FRFs of the assembly are written beside it."), true);
  CoupleWish wish{*scene_, as_path(result_file()), bounds_->isChecked()};
  for (const QString& file : measured_) wish.measured.push_back(as_path(file));
  line_->say(tr("Coupling …"));
  line_->worker().add([this, wish](const Worker::Watch& watch) -> Worker::Deliver {
    return [this, found = run_coupling(wish, watch)] {
      coupled_ = found;
      show_coupled();
    };
  });
}

void CouplePage::show_coupled() {
  const tasks::CoupleResult& result = coupled_->result;
  line_->say(q(report::couple_text(coupled_->scene, result)).section('\n', 0, 0) + "\n" +
                 (result.status == ident::Status::ok ? tr("written to %1").arg(as_name(result.result.path)) : q(result.message)),
             result.status != ident::Status::ok);
  if (result.records.empty()) return plots_->show_groups({});
  plots_->show_groups({{QString(), report::predicted_plots(result.frequency_hz, coupled_->frfs, most_points)},
                       {tr("condition number of S"), report::condition_plots(result, most_points)},
                       {tr("alpha"), alphas(*coupled_)}});
  resonances_->show_rows(resonance_rows(result));
  errors_->show_rows(coupling_errors(*coupled_));
  conditions_->show_rows(result.dependencies ? rows_of(report::conditions_table(*result.dependencies)) : CellRows());
}

QString CouplePage::command_line() const {
  return QStringLiteral("jointid couple %1 --out %2%3")
      .arg(shell_word(file_.isEmpty() ? tr("SCENE.toml") : file_), shell_word(result_file()),
           bounds_->isChecked() ? QStringLiteral(" --bounds") : QString());
}

}  // namespace jointid::gui
