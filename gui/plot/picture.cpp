#include "gui/plot/picture.hpp"

#include <qcustomplot.h>

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "base/error.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/output.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

constexpr int dpi = 96;
constexpr double png_scale = 2.0;  // pixels of the file for one of the window

/// As SVG or PDF.
QByteArray vector_picture(const QSize& size, const QString& ending, const std::function<void(QPaintDevice&)>& paint) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  if (ending == QLatin1String("svg")) {
    QSvgGenerator device;
    device.setOutputDevice(&buffer);
    device.setSize(size);
    device.setViewBox(QRect(QPoint(0, 0), size));
    paint(device);
  } else {
    QPdfWriter device(&buffer);
    device.setResolution(dpi);
    device.setPageSize(QPageSize(QSizeF(size) / dpi, QPageSize::Inch, QString(), QPageSize::ExactMatch));
    device.setPageMargins(QMarginsF(0, 0, 0, 0));
    paint(device);
  }
  return buffer.data();
}

template <class Image>
QByteArray as_png(const Image& image) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data();
}

}  // namespace

QByteArray picture_of(QCustomPlot& plot, const QString& ending) {
  if (ending == QLatin1String("png")) return as_png(plot.toPixmap(plot.width(), plot.height(), png_scale));
  return vector_picture(plot.size(), ending, [&plot](QPaintDevice& device) {
    QCPPainter painter(&device);
    painter.setMode(QCPPainter::pmVectorized);
    plot.toPainter(&painter, plot.width(), plot.height());
  });
}

QByteArray picture_of(const QSize& size, const std::function<void(QPainter&)>& paint, const QString& ending) {
  const auto paint_on = [&paint](QPaintDevice& device) {
    QPainter painter(&device);
    paint(painter);
  };
  if (ending != QLatin1String("png")) return vector_picture(size, ending, paint_on);
  QImage image(size * png_scale, QImage::Format_RGB32);
  image.setDevicePixelRatio(png_scale);
  paint_on(image);
  return as_png(image);
}

void save_plot(const QString& file, const Saveable& plot, const std::vector<std::filesystem::path>& inputs) {
  const QString ending = QFileInfo(file).suffix().toLower();
  if (ending == QLatin1String("csv")) return write_output(file, plot.table(','), inputs);
  if (!QStringList({"png", "svg", "pdf"}).contains(ending) && !(plot.is_film && ending == QLatin1String("gif"))) {
    throw InputError({ErrorKind::usage, file.toStdString(), "", "the name has no ending of a picture or table",
                      "end it with .png, .svg, .pdf or .csv"});
  }
  const QByteArray bytes = plot.picture(ending);
  write_output(file, {bytes.data(), static_cast<std::size_t>(bytes.size())}, inputs);
}

void ask_and_save(QWidget* parent, const Saveable& plot, const std::vector<std::filesystem::path>& inputs, const QString& proposed) {
  const QString filter = plot.is_film ? Said::tr("Pictures, tables and films (*.png *.svg *.pdf *.csv *.gif)")
                                      : Said::tr("Pictures and tables (*.png *.svg *.pdf *.csv)");
  const QString file = choose_file_to_save(parent, Said::tr("Save the plot"), proposed, filter, QStringLiteral("png"));
  if (file.isEmpty()) return;
  try {
    save_plot(file, plot, inputs);
  } catch (const InputError& error) {
    QMessageBox::warning(parent, Said::tr("Not saved"), QString::fromUtf8(error.what()));
  }
}

void copy_plot(const Saveable& plot) {
  auto* data = new QMimeData;
  data->setText(QString::fromStdString(plot.table('\t')));
  data->setImageData(QImage::fromData(plot.picture(QStringLiteral("png"))));
  QApplication::clipboard()->setMimeData(data);
}

}  // namespace jointid::gui
