#include "gui/geometry/drawn_springs.hpp"

#include <QStringList>
#include <algorithm>

#include "base/text.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

QString share_text(const tasks::JointSpring& spring) {
  QString text = q(digits(spring.share, "%.2g"));
  if (spring.share_half_width) text += QStringLiteral(" ± ") + q(digits(*spring.share_half_width));
  return text;
}

DrawnSpring drawn(const tasks::JointSpring& spring, std::int64_t first, std::int64_t second) {
  const QString share = share_text(spring);
  DrawnSpring out{first, second, spring.share, spring.tightness, spring.tightness == tasks::Tightness::alike ? QString() : share, {}};
  out.text = Said::tr("%1 – %2: %3 of the others (%4)").arg(first).arg(second).arg(share, q(spring.unknown));
  return out;
}

}  // namespace

std::vector<DrawnSpring> drawn_springs(const std::vector<tasks::JointSpring>& springs) {
  std::vector<DrawnSpring> out;
  for (const tasks::JointSpring& spring : springs) {
    for (const auto& [one, other] : spring.ends) {
      if (one.node == other.node) continue;
      const auto [first, second] = std::minmax(one.node, other.node);
      const auto same = [first = first, second = second](const DrawnSpring& each) { return each.first == first && each.second == second; };
      const auto found = std::ranges::find_if(out, same);
      if (found == out.end())
        out.push_back(drawn(spring, first, second));
      else if (spring.share < found->share)
        *found = drawn(spring, first, second);
    }
  }
  return out;
}

QString springs_text(const std::vector<DrawnSpring>& springs) {
  if (springs.empty()) return {};
  QStringList loose, doubtful;
  for (const DrawnSpring& each : springs) {
    if (each.tightness == tasks::Tightness::loose) loose << each.text;
    if (each.tightness == tasks::Tightness::doubtful) doubtful << each.text;
  }
  QStringList lines;
  if (!loose.isEmpty()) lines << Said::tr("Loose, red: %1.").arg(loose.join(QStringLiteral("; ")));
  if (!doubtful.isEmpty()) lines << Said::tr("Perhaps loose, brown: %1.").arg(doubtful.join(QStringLiteral("; ")));
  if (lines.isEmpty()) return Said::tr("No spring is looser than half of the others of its direction.");
  return lines.join(QLatin1Char('\n'));
}

}  // namespace jointid::gui
