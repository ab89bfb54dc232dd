#pragma once

#include <QPlainTextDocumentLayout>

namespace jointid::gui {

/// Lays lines out as QPlainTextEdit needs it, with room below one of them for what is to be said of it.
class AnnotatedLayout : public QPlainTextDocumentLayout {
  Q_OBJECT

 public:
  explicit AnnotatedLayout(QTextDocument* document);

  /// Leaves `height` pixels free below a block; -1: below none.
  void leave_room(int block, qreal height);
  qreal room() const { return height_; }
  int block() const { return block_; }

  QRectF blockBoundingRect(const QTextBlock& block) const override;

 private:
  int block_ = -1;
  qreal height_ = 0.0;
};

}  // namespace jointid::gui
