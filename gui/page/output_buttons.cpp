#include "gui/page/output_buttons.hpp"

#include <QPushButton>
#include <QVBoxLayout>

#include "base/error.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/output.hpp"
#include "gui/page/job_line.hpp"

namespace jointid::gui {

OutputButtons::OutputButtons(const std::string& name, JobLine& line, QWidget* parent) : QWidget(parent), line_(line) {
  named(this, (name + "_outputs").c_str(), tr("Save the results"));
  auto* report =
      push_button((name + "_report").c_str(), tr("Report…"), tr("Save the page that the command writes with --report"));
  auto* json = push_button((name + "_json").c_str(), tr("JSON…"), tr("Save what the command writes with --json"));
  auto* csv = push_button((name + "_csv").c_str(), tr("CSV…"), tr("Save what the command writes with --csv"));
  auto* row = new QVBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addLayout(row_of({}, {report, json, csv}));
  buttons_ = {{QStringLiteral("html"), report}, {QStringLiteral("json"), json}, {QStringLiteral("csv"), csv}};
  connect(report, &QPushButton::clicked, this, [this] { ask_and_write(tr("Pages (*.html)"), QStringLiteral("html")); });
  connect(json, &QPushButton::clicked, this, [this] { ask_and_write(tr("JSON (*.json)"), QStringLiteral("json")); });
  connect(csv, &QPushButton::clicked, this, [this] { ask_and_write(tr("Tables (*.csv)"), QStringLiteral("csv")); });
  connect(&line_, &JobLine::busy_changed, this, &OutputButtons::show_state);
  show_state();
}

void OutputButtons::offer(Outputs outputs) {
  outputs_ = std::move(outputs);
  show_state();
}

void OutputButtons::show_state() {
  for (const auto& [ending, button] : buttons_) button->setEnabled(outputs_.contains(ending) && !line_.is_busy());
}

void OutputButtons::ask_and_write(const QString& filter, const QString& ending) {
  const QString proposed = objectName().section(QLatin1Char('_'), 0, 0) + QLatin1Char('.') + ending;
  const QString file = choose_file_to_save(this, tr("Save the results"), proposed, filter, ending);
  if (!file.isEmpty()) write(file, ending);
}

void OutputButtons::write(const QString& file, const QString& ending) {
  if (!outputs_.contains(ending)) return;
  try {
    write_output(file, outputs_.at(ending)(), inputs_);
    line_.say(tr("Written to %1.").arg(file));
  } catch (const InputError& error) {
    line_.say(QString::fromUtf8(error.what()), true);
  }
}

}  // namespace jointid::gui
