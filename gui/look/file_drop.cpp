#include "gui/look/file_drop.hpp"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>
#include <utility>

namespace jointid::gui {
namespace {

/// What is dropped and does not lie on this machine is left out.
QStringList local_files(const QMimeData* data) {
  QStringList files;
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile()) files << url.toLocalFile();
  }
  return files;
}

class FileDrop final : public QObject {
 public:
  FileDrop(QWidget& widget, std::function<void(const QStringList&)> open) : QObject(&widget), open_(std::move(open)) {}

 private:
  bool eventFilter(QObject* widget, QEvent* event) override {
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop) return QObject::eventFilter(widget, event);
    auto* const drop = static_cast<QDropEvent*>(event);  // entering is one
    const QStringList files = local_files(drop->mimeData());
    if (files.isEmpty()) return QObject::eventFilter(widget, event);
    if (event->type() == QEvent::Drop) open_(files);
    drop->acceptProposedAction();
    return true;
  }

  std::function<void(const QStringList&)> open_;
};

}  // namespace

void let_drop_files(QWidget& widget, std::function<void(const QStringList&)> open) {
  widget.setAcceptDrops(true);
  widget.installEventFilter(new FileDrop(widget, std::move(open)));
}

}  // namespace jointid::gui
