#include "gui/look/job_progress.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "gui/look/named.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

constexpr double first_s = 0.5;
constexpr int steps = 1000;
constexpr int width_px = 300;

}  // namespace

std::optional<double> TimeLeft::note(const QString& stage, double share, double now_s) {
  if (stage != stage_ || share < begun_share_ || share < 0.0) {
    stage_ = stage;
    begun_s_ = now_s;
    begun_share_ = share;
    return std::nullopt;
  }
  const double elapsed = now_s - begun_s_, done = share - begun_share_;
  if (elapsed < first_s || !(done > 0.0)) return std::nullopt;
  return elapsed * (1.0 - share) / done;
}

/// What the library tells of its work, but for numbers of iterations.
[[maybe_unused]] constexpr const char* stages[] = {
    QT_TRANSLATE_NOOP("Said", "planning"),     QT_TRANSLATE_NOOP("Said", "reading"),         QT_TRANSLATE_NOOP("Said", "solving"),
    QT_TRANSLATE_NOOP("Said", "bootstrap"),    QT_TRANSLATE_NOOP("Said", "identifiability"), QT_TRANSLATE_NOOP("Said", "trials"),
    QT_TRANSLATE_NOOP("Said", "constraining"), QT_TRANSLATE_NOOP("Said", "standard errors")};

QString duration_text(double seconds) {
  if (seconds < 90.0) return JobProgress::tr("%1 s").arg(std::ceil(seconds));
  if (seconds < 600.0) {
    const int whole = static_cast<int>(std::ceil(seconds));
    return JobProgress::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
  }
  if (seconds < 5400.0) return JobProgress::tr("%1 min").arg(std::ceil(seconds / 60.0));
  return JobProgress::tr("%1 h").arg(seconds / 3600.0, 0, 'f', 1);
}

QLayout* status_row(QLabel* status, JobProgress* progress) {
  status->setWordWrap(true);
  status->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout;
  row->addWidget(status, 1);
  row->addWidget(progress, 0, Qt::AlignTop);
  return row;
}

JobProgress::JobProgress(const char* name, QWidget* parent) : QProgressBar(parent) {
  named(this, name, tr("Progress"));
  setFixedWidth(width_px);
  hide();
}

void JobProgress::show_share(const JobShare& share) {
  const auto left = left_.note(share.is_whole ? QString() : share.stage, share.share, seconds_since(begun_));
  const QString counted = share.of > 1 ? tr("%1 of %2: ").arg(share.number).arg(share.of) : QString();
  setRange(0, steps);
  setValue(share.share < 0.0 ? 0 : static_cast<int>(steps * share.share));
  setFormat(counted + said(share.stage.toUtf8().constData()) +
            (share.share < 0.0 ? QStringLiteral(" …") : QStringLiteral(" %p %")) +
            (left ? tr(", %1 left").arg(duration_text(*left)) : QString()));
}

void JobProgress::set_busy(bool busy) {
  left_ = {};
  setRange(0, 0);  // until it is known what runs
  setFormat({});
  setVisible(busy);
}

}  // namespace jointid::gui
