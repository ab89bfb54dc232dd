#include "gui/data/data_words.hpp"

#include "gui/look/said.hpp"

namespace jointid::gui {

QString text_of(GridFigure figure) {
  switch (figure) {
    case GridFigure::missing:
      return Said::tr("missing lines");
    case GridFigure::coherence:
      return Said::tr("mean coherence");
    case GridFigure::deviation:
      return Said::tr("deviation over |H|");
    case GridFigure::reciprocity:
      return Said::tr("reciprocity error");
  }
  return {};
}

QString about(const frf::FrfHeader& header) {
  const auto noise = [&]() -> QString {
    if (header.noise == frf::NoiseRecord::coherence) return Said::tr("coherence of %1 averages").arg(header.averages);
    if (header.noise == frf::NoiseRecord::variance) return Said::tr("variances");
    return Said::tr("noise not stated");
  };
  QString text = Said::tr("%1, %2 lines, %3 to %4 Hz; %5 × %6 FRFs; %7")
                     .arg(QString::fromStdString(frf::name(header.quantity)))
                     .arg(header.lines())
                     .arg(header.frequency_hz.front())
                     .arg(header.frequency_hz.back())
                     .arg(header.response.size())
                     .arg(header.reference.size())
                     .arg(noise());
  for (const auto* notes : {&header.changes, &header.doubts}) {
    for (const std::string& note : *notes) text += "\n" + QString::fromStdString(note);
  }
  return text;
}

}  // namespace jointid::gui
