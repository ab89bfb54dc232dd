#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "frf/uff/uff_lines.hpp"

namespace jointid::gui {

/// Lines drawn by hand from node to node: the first pick begins one, the second ends it.
class LinePen {
 public:
  const std::vector<frf::NodeLine>& own() const { return own_; }
  /// The line that was chosen stays so, if it is still there.
  void set_own(std::vector<frf::NodeLine> lines);

  /// True where a line was added. `of_files`: those that are there already.
  bool pick(std::int64_t node, const std::vector<frf::NodeLine>& of_files);
  void choose(const frf::NodeLine& line);
  /// The line that is chosen; false where none is.
  bool remove();
  /// Goes to the node before or behind the one where the pen is; `nodes` in their order.
  void step(const std::vector<std::int64_t>& nodes, int by);
  /// Forgets what is picked and chosen.
  void lift();

  const std::optional<std::int64_t>& at() const { return at_; }           ///< where the keys are
  const std::optional<std::int64_t>& from() const { return from_; }       ///< the first node of a line
  const std::optional<frf::NodeLine>& chosen() const { return chosen_; }  ///< one of own()
  /// What was done, and what can be done next.
  QString text() const;

 private:
  std::vector<frf::NodeLine> own_;
  std::optional<std::int64_t> at_, from_;
  std::optional<frf::NodeLine> chosen_, of_files_;  ///< of_files_: two nodes that the files join
};

/// In either direction.
bool joins(const frf::NodeLine& line, std::int64_t one, std::int64_t other);

}  // namespace jointid::gui
