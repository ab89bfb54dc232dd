#include "gui/scene/annotated_layout.hpp"

#include <QTextBlock>
#include <QTextDocument>

namespace jointid::gui {

AnnotatedLayout::AnnotatedLayout(QTextDocument* document) : QPlainTextDocumentLayout(document) {}

void AnnotatedLayout::leave_room(int block, qreal height) {
  if (block == block_ && height == height_) return;
  block_ = block;
  height_ = block < 0 ? 0.0 : height;
  Q_EMIT documentSizeChanged(documentSize());
  requestUpdate();
}

QRectF AnnotatedLayout::blockBoundingRect(const QTextBlock& block) const {
  QRectF rectangle = QPlainTextDocumentLayout::blockBoundingRect(block);
  if (block.isValid() && block.blockNumber() == block_) rectangle.setHeight(rectangle.height() + height_);
  return rectangle;
}

}  // namespace jointid::gui
