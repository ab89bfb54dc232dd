#pragma once

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace jointid::gui {

/// Ticks with as many digits as tell neighbours apart: 1.08547 to 1.08548 does not repeat one number.
class DistinctTicker : public QCPAxisTicker {
 protected:
  double getTickStep(const QCPRange& range) override { return step_ = QCPAxisTicker::getTickStep(range); }
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    constexpr int most_digits = 15;
    const double steps = step_ > 0.0 ? std::abs(tick) / step_ : 0.0;
    const int needed = steps > 1.0 ? static_cast<int>(std::ceil(std::log10(steps))) + 2 : 0;
    return QCPAxisTicker::getTickLabel(tick, locale, format, std::clamp(needed, precision, most_digits));
  }

 private:
  double step_ = 0.0;
};

}  // namespace jointid::gui
