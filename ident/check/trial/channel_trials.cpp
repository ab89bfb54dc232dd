#include "ident/check/trial/channel_trials.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "ident/check/test/misfit.hpp"
#include "ident/check/trial/measured_channel.hpp"

namespace jointid::ident {
namespace {

using Files = std::vector<CheckedFile>;

constexpr std::size_t candidates_per_test = 3, all_partners = 14;

/// Nothing where the file does not have both.
void swap_channels(CheckedFile& file, Role role, const frf::Dof& a, const frf::Dof& b) {
  if (!has_role(file, role, a) || !has_role(file, role, b)) return;
  const auto i = static_cast<Eigen::Index>(place_of(dofs_of(file, role), a)),
             j = static_cast<Eigen::Index>(place_of(dofs_of(file, role), b));
  for (Eigen::MatrixXcd& line : file.frfs) {
    if (role == Role::response) {
      line.row(i).swap(line.row(j));
    } else {
      line.col(i).swap(line.col(j));
    }
  }
}

/// The few largest, as long as they are not much below the largest.
std::vector<std::size_t> outstanding(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  order.resize(std::min(order.size(), candidates_per_test));
  const double least = order.empty() ? 0.0 : 0.25 * values[order.front()];
  std::erase_if(order, [&](std::size_t k) { return values[k] < least; });
  return order;
}

/// Tests that are worse than others, whose channels may be wrong; all where none is.
std::vector<bool> standing_out(const std::vector<double>& levels) {
  std::vector<bool> out(levels.size());
  const double least = levels.empty() ? 0.0 : *std::ranges::min_element(levels);
  for (std::size_t i = 0; i < levels.size(); ++i) out[i] = levels[i] > large_misfit || levels[i] > 2.5 * least;
  if (std::ranges::none_of(out, [](bool each) { return each; })) out.assign(levels.size(), true);
  return out;
}

/// The rows that a span test would rather be without, and the coordinates whose pairs are least reciprocal.
MeasuredChannels candidate_channels(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening) {
  MeasuredChannels found;
  std::vector<double> levels;
  for (const SpanTest& test : screening.span) levels.push_back(test.level);
  const std::vector<bool> worse = standing_out(levels);
  for (std::size_t s = 0; s < setups.size(); ++s) {
    if (!worse[s]) continue;
    const Role role = setups[s].transposed ? Role::reference : Role::response;
    for (const std::size_t k : outstanding(screening.span[s].share)) {
      found.add(files, setups[s].assembly, role, setups[s].rows[k]);
      found.add(files, setups[s].part, role, setups[s].rows[k]);
    }
  }
  for (std::size_t f = 0; f < files.size(); ++f) {
    const double usual = median(screening.reciprocity[f].row);
    for (const std::size_t k : outstanding(screening.reciprocity[f].row)) {
      if (screening.reciprocity[f].row[k] < 2.0 * usual) continue;
      found.add(files, f, Role::response, screening.reciprocity[f].dofs[k]);
      found.add(files, f, Role::reference, screening.reciprocity[f].dofs[k]);
    }
  }
  return found;
}

MistakeTrial sign_trial(const Files& files, const MeasuredChannel& c) {
  return {.kind = SuspectKind::sign,
          .files = {c.file},
          .dofs = {c.dof},
          .what = "the " + channel_word(c.role) + " at " + c.dof.name() + " points the other way",
          .remedy = remedy_in(files[c.file].name, role_key("flip", c.role) + " = [" + quoted_dof(c.dof) + "]"),
          .undo = [c](Files& all) { scale_channel(all[c.file], c.role, c.dof, -1.0); }};
}

MistakeTrial both_signs_trial(const Files& files, std::size_t file, const frf::Dof& dof) {
  const std::string name = quoted_dof(dof);
  return {.kind = SuspectKind::sign,
          .files = {file},
          .dofs = {dof},
          .what = "the direction of " + dof.name() + " is the other one, of sensor and excitation",
          .remedy = remedy_in(files[file].name, "flip = [" + name + "]\nflip_reference = [" + name + "]"),
          .undo = [file, dof](Files& all) {
            scale_channel(all[file], Role::response, dof, -1.0);
            scale_channel(all[file], Role::reference, dof, -1.0);
          }};
}

std::string swap_line(Role role, const frf::Dof& a, const frf::Dof& b) {
  return role_key("rename", role) + " = { " + quoted_dof(a) + " = " + quoted_dof(b) + ", " + quoted_dof(b) + " = " +
         quoted_dof(a) + " }";
}

MistakeTrial swap_trial(const Files& files, const MeasuredChannel& c, const frf::Dof& other) {
  return {.kind = SuspectKind::swap,
          .files = {c.file},
          .dofs = {c.dof, other},
          .what = "the labels of " + c.dof.name() + " and " + other.name() + " are exchanged (" + channel_word(c.role) + "s)",
          .remedy = remedy_in(files[c.file].name, swap_line(c.role, c.dof, other)),
          .undo = [c, other](Files& all) { swap_channels(all[c.file], c.role, c.dof, other); }};
}

MistakeTrial both_swapped_trial(const Files& files, std::size_t file, const frf::Dof& a, const frf::Dof& b) {
  return {.kind = SuspectKind::swap,
          .files = {file},
          .dofs = {a, b},
          .what = "the labels of " + a.name() + " and " + b.name() + " are exchanged, of sensors and excitation",
          .remedy = remedy_in(files[file].name, swap_line(Role::response, a, b) + "\n" + swap_line(Role::reference, a, b)),
          .undo = [file, a, b](Files& all) {
            swap_channels(all[file], Role::response, a, b);
            swap_channels(all[file], Role::reference, a, b);
          }};
}

}  // namespace

std::vector<MistakeTrial> channel_trials(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening) {
  const MeasuredChannels candidates = candidate_channels(files, setups, screening);
  std::vector<MistakeTrial> out;
  for (const MeasuredChannel& c : candidates.channels) {
    const Dofs& own = dofs_of(files[c.file], c.role);
    const bool both = c.role == Role::response && has_role(files[c.file], Role::reference, c.dof);
    out.push_back(sign_trial(files, c));
    if (both) out.push_back(both_signs_trial(files, c.file, c.dof));
    const auto is_candidate = [&](const frf::Dof& dof) {
      return std::ranges::any_of(candidates.channels, [&](const MeasuredChannel& o) {
        return o.file == c.file && o.role == c.role && o.dof.same_coordinate(dof);
      });
    };
    for (const frf::Dof& other : own) {
      if (other.same_coordinate(c.dof)) continue;
      const bool listed = is_candidate(other);
      if (own.size() > all_partners && !listed) continue;
      if (listed && frf::coordinate_key(other) < frf::coordinate_key(c.dof)) continue;  // once per pair
      out.push_back(swap_trial(files, c, other));
      if (both && listed && has_role(files[c.file], Role::reference, other))
        out.push_back(both_swapped_trial(files, c.file, c.dof, other));
    }
  }
  return out;
}

}  // namespace jointid::ident
