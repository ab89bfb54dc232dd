#include "gui/geometry/line_pen.hpp"

#include <algorithm>

#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

std::optional<frf::NodeLine> line_between(const std::vector<frf::NodeLine>& lines, std::int64_t one, std::int64_t other) {
  const auto found = std::ranges::find_if(lines, [&](const frf::NodeLine& line) { return joins(line, one, other); });
  return found == lines.end() ? std::nullopt : std::optional(*found);
}

QString line_name(const frf::NodeLine& line) { return QStringLiteral("%1 – %2").arg(line[0]).arg(line[1]); }

}  // namespace

bool joins(const frf::NodeLine& line, std::int64_t one, std::int64_t other) {
  return (line[0] == one && line[1] == other) || (line[0] == other && line[1] == one);
}

void LinePen::set_own(std::vector<frf::NodeLine> lines) {
  own_ = std::move(lines);
  if (chosen_ && std::ranges::find(own_, *chosen_) == own_.end()) chosen_.reset();
}

bool LinePen::pick(std::int64_t node, const std::vector<frf::NodeLine>& of_files) {
  at_ = node;
  chosen_.reset();
  of_files_.reset();
  if (!from_ || *from_ == node) {
    from_ = from_ ? std::nullopt : std::optional(node);
    return false;
  }
  const frf::NodeLine line = {*from_, node};
  from_.reset();
  of_files_ = line_between(of_files, line[0], line[1]);
  chosen_ = line_between(own_, line[0], line[1]);
  if (chosen_ || of_files_) return false;
  own_.push_back(line);
  chosen_ = line;
  return true;
}

void LinePen::choose(const frf::NodeLine& line) {
  lift();
  chosen_ = line;
}

bool LinePen::remove() {
  if (!chosen_) return false;
  std::erase(own_, *chosen_);
  chosen_.reset();
  return true;
}

void LinePen::step(const std::vector<std::int64_t>& nodes, int by) {
  if (nodes.empty()) return;
  const auto size = static_cast<std::ptrdiff_t>(nodes.size());
  const auto here = at_ ? std::ranges::find(nodes, *at_) - nodes.begin() : by > 0 ? size - 1 : 0;
  at_ = nodes[static_cast<std::size_t>((here % size + by + size) % size)];
}

void LinePen::lift() {
  from_.reset();
  chosen_.reset();
  of_files_.reset();
}

QString LinePen::text() const {
  if (chosen_) return Said::tr("Line %1. Delete removes it.").arg(line_name(*chosen_));
  if (of_files_) return Said::tr("Line %1 is one of the files.").arg(line_name(*of_files_));
  if (from_) return Said::tr("A line from node %1. Pick the other node, or press Esc.").arg(*from_);
  return Said::tr(
      "Pick two nodes for a line between them: by click, or by Page Up, Page Down and Space. A click on a line chooses it.");
}

}  // namespace jointid::gui
