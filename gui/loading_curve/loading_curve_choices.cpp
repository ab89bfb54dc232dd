#include "gui/loading_curve/loading_curve_choices.hpp"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>

#include "base/text.hpp"
#include "friction/fit/fit_start.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/choice_button.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

constexpr int unit_width_px = 60, letters_of_column = 8;

QLineEdit* unit_box(const char* name, const QString& title, const QString& example) {
  auto* box = named(new QLineEdit, name, title, title);
  box->setPlaceholderText(example);
  box->setMaximumWidth(unit_width_px);
  return box;
}

QComboBox* word_box(const char* name, const QString& title, const QStringList& words) {
  auto* box = named(new QComboBox, name, title, title);
  box->addItems(words);
  return box;
}

QStringList law_words() {
  QStringList out;
  for (const std::string& law : friction::fitted_laws()) out << q(law);
  return out;
}

/// The words of the command, where a column is chosen.
std::string chosen(const QComboBox& box) { return box.currentIndex() < 1 ? std::string() : box.currentText().toStdString(); }

QString option(const char* name, const std::string& value) {
  return value.empty() ? QString() : QStringLiteral(" --%1 %2").arg(QLatin1String(name), shell_word(q(value)));
}

}  // namespace

LoadingCurveChoices::LoadingCurveChoices(QWidget* parent) : QWidget(parent) {
  named(this, "curve_choices", tr("Columns and laws"));
  displacement_ = column_box("curve_displacement", tr("displacement"), tr("Column of displacements, angles or amplitudes"));
  force_ = column_box("curve_force", tr("force"), tr("Column of forces or torques"));
  energy_ = column_box("curve_energy", tr("energy"), tr("Instead of forces: energies per cycle over amplitude"));
  stiffness_ = column_box("curve_stiffness", tr("k_e"), tr("Instead of forces: equivalent stiffnesses over amplitude …"));
  damping_ = column_box("curve_damping", tr("d_e"), tr("… and equivalent dampings"));
  unit_ = unit_box("curve_unit", tr("Unit of displacements. Empty: that of the header, else m"), QStringLiteral("mm"));
  force_unit_ = unit_box("curve_force_unit", tr("Unit of forces. Empty: that of the header, else N"), QStringLiteral("uN"));
  kind_ = word_box("curve_kind", tr("Loaded once from rest, or cycles"), {"auto", "loading", "loops"});
  weighting_ = word_box("curve_weighting", tr("Weighting of the residuals"), {"largest", "none", "relative", "travel"});
  laws_ = new ChoiceButton("curve_laws", tr("laws"), law_words(), tr("all"), tr("Laws to fit; nothing chosen: all"));
  limit_ = named(new QDoubleSpinBox, "curve_limit", tr("Given friction limit"), tr("Given friction limit. 0: unknown"));
  limit_->setRange(0.0, 1e9);
  limit_->setDecimals(4);
  limit_->setPrefix(tr("limit "));
  limit_->setSuffix(QStringLiteral(" N"));
  limit_->setSpecialValueText(tr("limit: unknown"));
  limit_->findChild<QLineEdit*>()->setAccessibleName(tr("Given friction limit"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({displacement_, unit_, force_, force_unit_, stiffness_, damping_, energy_}, {}));
  rows->addLayout(row_of({laws_, kind_, weighting_, limit_}, {}));
}

QComboBox* LoadingCurveChoices::column_box(const char* name, const QString& title, const QString& hint) {
  auto* box = named(new QComboBox, name, title, hint);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(letters_of_column);
  box->setProperty("title", title);
  box->addItem(title);
  return box;
}

void LoadingCurveChoices::offer(const QStringList& columns) {
  for (QComboBox* box : {displacement_, force_, energy_, stiffness_, damping_}) {
    const QString before = box->currentText();
    box->clear();
    box->addItem(box->property("title").toString());
    box->addItems(columns);
    box->setCurrentIndex(std::max(0, box->findText(before)));
  }
}

tasks::LoadingCurveTask LoadingCurveChoices::task() const {
  tasks::LoadingCurveTask out;
  out.displacement = chosen(*displacement_);
  out.force = chosen(*force_);
  out.energy = chosen(*energy_);
  out.stiffness = chosen(*stiffness_);
  out.damping = chosen(*damping_);
  out.unit = unit_->text().trimmed().toStdString();
  out.force_unit = force_unit_->text().trimmed().toStdString();
  out.kind = kind_->currentText().toStdString();
  out.weighting = weighting_->currentText().toStdString();
  for (const QString& law : laws_->chosen()) out.laws.push_back(law.toStdString());
  if (limit_->value() > 0.0) out.limit = limit_->value();
  return out;
}

QString loading_curve_command(const tasks::LoadingCurveTask& task) {
  const tasks::LoadingCurveTask usual;
  QString text = QStringLiteral("jointid loading-curve");
  for (const auto& file : task.files) text += " " + shell_word(as_name(file));
  text += option("displacement", task.displacement) + option("unit", task.unit) + option("force", task.force) +
          option("force-unit", task.force_unit) + option("stiffness", task.stiffness) + option("damping", task.damping) +
          option("energy", task.energy);
  if (task.kind != usual.kind) text += option("kind", task.kind);
  if (task.weighting != usual.weighting) text += option("weighting", task.weighting);
  QStringList laws;
  for (const std::string& law : task.laws) laws << q(law);
  if (!laws.isEmpty()) text += " --law " + laws.join(',');
  if (task.limit) text += " --limit " + q(digits(*task.limit, "%.17g"));
  return text;
}

}  // namespace jointid::gui
