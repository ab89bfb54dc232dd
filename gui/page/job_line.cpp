#include "gui/page/job_line.hpp"

#include <QLayout>

#include "gui/look/buttons.hpp"
#include "gui/look/job_progress.hpp"
#include "gui/look/named.hpp"
#include "gui/look/status_label.hpp"

namespace jointid::gui {

JobLine::JobLine(const std::string& name, const QString& accessible_name, const QString& cancel_hint, QWidget* parent)
    : QWidget(parent), worker_(new Worker(this)), cancelled_text_(tr("Cancelled.")) {
  named(this, (name + "_line").c_str(), accessible_name);
  status_ = named(new StatusLabel, (name + "_status").c_str(), accessible_name);
  progress_ = new JobProgress((name + "_progress").c_str());
  cancel_ = push_button((name + "_cancel").c_str(), tr("Cancel"), cancel_hint);
  cancel_->setEnabled(false);
  QLayout* const row = status_row(status_, progress_);
  row->setContentsMargins(0, 0, 0, 0);
  setLayout(row);
  connect(cancel_, &QPushButton::clicked, this, &JobLine::cancel);
  connect(worker_, &Worker::failed, this, [this](const InputError& error) {
    say(QString::fromUtf8(error.what()), true);
    Q_EMIT failed(error);
  });
  connect(worker_, &Worker::cancelled, this, [this] { say(cancelled_text_); });
  connect(worker_, &Worker::busy_changed, this, [this](bool busy) {
    progress_->set_busy(busy);
    cancel_->setEnabled(busy);
    Q_EMIT busy_changed(busy);
  });
  connect(worker_, &Worker::progressed, progress_, &JobProgress::show_share);
}

void JobLine::say(const QString& text, bool bad) {
  status_->set_bad(bad);
  status_->setText(text);
}

QString JobLine::status() const { return status_->text(); }

}  // namespace jointid::gui
