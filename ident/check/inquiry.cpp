#include "ident/check/inquiry.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/eigen.hpp"
#include "base/parallel.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "ident/check/agreement.hpp"
#include "ident/check/repeated_numbers.hpp"
#include "ident/check/rest.hpp"
#include "ident/check/rigid_mass.hpp"
#include "ident/check/sameness.hpp"
#include "ident/check/test/screening.hpp"
#include "ident/check/trial/axis_trials.hpp"
#include "ident/check/trial/group_trials.hpp"
#include "ident/check/trial/trials.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t screening_lines = 64, trial_lines = 24;  ///< at most
constexpr double screening_work = 2.5e6, trial_work = 7e5;     ///< products of complex numbers, about
constexpr std::size_t rest_lines = 256;
constexpr double rest_work = 2e6;
constexpr double clear_score = 1.2;                            ///< of a trial beside which stretched axes need no search
constexpr double noise_that_halves = 0.15;
constexpr double tie = 0.93;     ///< of the best score: cannot be told from it
constexpr double certain = 0.7;  ///< score whose confidence is 1 − 1/e

using Files = std::vector<CheckedFile>;

Files lines_of(const Files& all, std::size_t count) {
  Files some;
  for (const CheckedFile& file : all) some.push_back(at_lines(file, spread_lines(file.frfs.size(), count)));
  return some;
}

/// What a trial changed most, in words.
std::string change_text(const Misfit& before, const Misfit& after) {
  std::string text;
  const auto add = [&](const std::vector<double>& was, const std::vector<double>& is, const char* what) {
    double ratio = 1.05;
    std::size_t at = was.size();
    for (std::size_t i = 0; i < was.size(); ++i) {
      if (const double r = (was[i] + 1e-3) / (is[i] + 1e-3); r > ratio) {
        ratio = r;
        at = i;
      }
    }
    if (at == was.size()) return;
    text += (text.empty() ? "" : ", ") + std::string(what) + " from " + percent(was[at]) + " to " + percent(is[at]);
  };
  add(before.span, after.span, "the part of the assembly's FRFs that substructures and joint forces do not explain");
  add(before.reciprocity, after.reciprocity, "the difference of H_ij and H_ji");
  double active = 0.0;
  for (std::size_t f = 0; f < before.active.size(); ++f) active += before.active[f] - after.active[f];
  if (active > 0.3) text += std::string(text.empty() ? "" : ", and ") + "driving points take energy again";
  return text;
}

struct Scored {
  MistakeTrial trial;
  Misfit after;
  double score = 0.0;
};

/// What of a scene is not among the files of an inquiry.
struct Surroundings {
  Dofs elsewhere;               ///< coordinates of other parts
  std::size_t chosen_from = 1;  ///< parts that might have been inquired
};

/// Checks one set of files: finds the mistake that explains most, undoes it, and looks for the next.
class Inquiry {
 public:
  Inquiry(Files files, const Dofs& joint, const Surroundings& around, const Control& control, bool with_axis)
      : all_(std::move(files)),
        chosen_from_(static_cast<double>(around.chosen_from)),
        joint_(joint),
        setups_(span_setups(all_, joint, around.elsewhere)),
        control_(control),
        with_axis_(with_axis),
        screening_(lines_for(setups_, screening_lines, screening_work)),
        trials_(lines_for(setups_, trial_lines, trial_work)),
        threads_(screening_ < screening_lines ? threads_or_cores(control.threads) : 1) {}

  /// Of the files as they are, at the lines of the last test.
  std::vector<ReciprocityMap> reciprocity() const {
    std::vector<ReciprocityMap> maps;
    for (const CheckedFile& file : lines_of(all_, lines_for(setups_, rest_lines, rest_work))) {
      if (ReciprocityMap map = reciprocity_map(file); !map.dofs.empty()) maps.push_back(std::move(map));
    }
    return maps;
  }

  std::vector<Suspect> suspects() {
    std::vector<Suspect> found;
    const Files lines = lines_of(all_, screening_);
    Screening screening = screened(lines);
    noise_ = screening.noise;
    for (Suspect& same : find_sameness(lines, setups_, noise_)) found.push_back(std::move(same));
    if (!found.empty()) return found;
    const std::size_t rounds = all_.size() + 2;
    for (std::size_t round = 0; round < rounds && one_round(screening, found); ++round)
      screening = screened(lines_of(all_, screening_));
    const std::size_t rest = lines_for(setups_, rest_lines, rest_work);
    if (found.empty()) found = unexplained(lines_of(all_, rest), setups_, screening, noise_, with_axis_);
    return found;
  }

 private:
  Screening screened(const Files& lines) const {
    Screening out = screen(lines, setups_, threads_);
    out.chosen_from = chosen_from_;
    return out;
  }

  bool one_round(const Screening& screening, std::vector<Suspect>& found) {
    stop_if(control_.interrupted);
    const Files small = lines_of(all_, trials_);
    const Misfit before = misfit_of(small, setups_, noise_, threads_);
    std::vector<Scored> scored;
    for (MistakeTrial& trial : trials_of(small, setups_, screening, before)) judge(std::move(trial), small, before, scored);
    for (MistakeTrial& trial : group_trials(small, joint_, setups_, screening, threads_)) judge(std::move(trial), small, before, scored);
    if (with_axis_ && best_score(scored) < clear_score) {
      for (MistakeTrial& trial : axis_trials(all_, joint_)) {
        judge(std::move(trial), small, before, scored);
      }
    }
    std::ranges::stable_sort(scored, std::ranges::greater{}, &Scored::score);
    if (scored.empty()) return false;
    sharpen_group(small, before, scored.front());
    report(scored, before, found);
    scored.front().trial.undo(all_);
    return true;
  }

  static double best_score(const std::vector<Scored>& scored) {
    double best = 0.0;
    for (const Scored& each : scored) best = std::max(best, each.score);
    return best;
  }

  void judge(MistakeTrial trial, const Files& small, const Misfit& before, std::vector<Scored>& scored) const {
    const double least = trial.least_score;
    Scored of = scored_of(std::move(trial), small, before);
    if (of.score >= least) scored.push_back(std::move(of));
  }

  /// Takes single references into the group of a mistake, or out of it, as long as that heals more: their levels alone do not always tell
  /// who has it.
  void sharpen_group(const Files& small, const Misfit& before, Scored& best) const {
    constexpr double more = 0.02;
    constexpr std::size_t most_references = 64, most_rounds = 3;
    if (!best.trial.in_others) return;
    const Dofs& all = small[best.trial.files.front()].references;
    if (all.size() > most_references) return;
    bool moved = true;
    for (std::size_t round = 0; moved && round < most_rounds; ++round) {
      moved = false;
      for (const frf::Dof& dof : all) {
        Dofs group;
        for (const frf::Dof& each : all) {
          const bool in = place_of(best.trial.references, each) != frf::npos;
          if (in != each.same_coordinate(dof)) group.push_back(each);
        }
        if (group.empty()) continue;
        Scored other = scored_of(best.trial.in_others(group), small, before);
        if (!(other.score > best.score + more)) continue;
        best = std::move(other);
        moved = true;
      }
    }
  }

  Scored scored_of(MistakeTrial trial, const Files& small, const Misfit& before) const {
    stop_if(control_.interrupted);
    Touched touched{.files = std::vector<bool>(all_.size(), false), .only_span = trial.only_span};
    for (const std::size_t f : trial.files) touched.files[f] = true;
    const auto with = [&](const std::function<void(Files&)>& change) {
      Files changed = trial.only_span ? all_ : small;
      change(changed);
      if (trial.only_span) changed = lines_of(changed, trials_);
      return misfit_of(changed, setups_, noise_, before, touched, threads_);
    };
    const Misfit after = with(trial.undo);
    const double score = (healing(trial.leave ? with(trial.leave) : before, after) + trial.bonus) / doubt(touched, after);
    return {std::move(trial), after, score};
  }

  /// Noise makes healing by chance: what counts grows with what is left afterwards, of the worst test that the trial touches; of files
  /// with covariances those that are weighed by them.
  double doubt(const Touched& touched, const Misfit& after) const {
    const bool weighed = std::ranges::any_of(setups_, [&](const SpanSetup& setup) { return setup.weighed && touched.setup(setup); });
    double left = 0.0;
    for (std::size_t s = 0; s < setups_.size(); ++s) {
      const bool counts = !weighed || setups_[s].weighed;
      if (counts && touched.setup(setups_[s])) left = std::max(left, after.span[s]);
    }
    return 1.0 + std::pow(left / noise_that_halves, 2);
  }

  /// The best trial, and others that cannot be told from it and accuse another file.
  void report(const std::vector<Scored>& scored, const Misfit& before, std::vector<Suspect>& found) const {
    const Scored& best = scored.front();
    std::vector<const Scored*> equal = {&best};
    for (const Scored& other : scored) {
      const bool elsewhere = std::ranges::none_of(equal, [&](const Scored* e) { return e->trial.files == other.trial.files; });
      const bool alike = other.trial.kind == best.trial.kind && other.trial.files.size() == best.trial.files.size();
      if (elsewhere && alike && other.score >= tie * best.score) equal.push_back(&other);
    }
    for (const Scored* each : equal) add(*each, before, equal.size(), found);
  }

  void add(const Scored& scored, const Misfit& before, std::size_t equals, std::vector<Suspect>& found) const {
    const MistakeTrial& trial = scored.trial;
    const std::string change = change_text(before, scored.after);
    std::string evidence = trial.what + (change.empty() ? "" : "; undone, it brings " + change);
    if (equals > 1) evidence += "; the data do not determine which of the files it is";
    const double confidence = (1.0 - std::exp(-scored.score / certain)) / static_cast<double>(equals);
    for (const std::size_t f : trial.kind == SuspectKind::exchange ? std::vector{trial.files.front()} : trial.files) {
      std::string remedy = trial.remedy;
      if (trial.files.size() > 1 && trial.kind != SuspectKind::exchange && f != trial.files.front())
        remedy = "as for " + all_[trial.files.front()].name;
      found.push_back({.kind = trial.kind,
                       .file = all_[f].name,
                       .dofs = trial.dofs,
                       .evidence = evidence,
                       .confidence = confidence,
                       .remedy = remedy});
    }
  }

  Files all_;
  double chosen_from_;
  const Dofs& joint_;
  std::vector<SpanSetup> setups_;
  std::vector<double> noise_;
  const Control& control_;
  bool with_axis_;
  std::size_t screening_, trials_;  ///< lines
  std::size_t threads_;             ///< one where lines are quickly tested
};

/// Each kind, file and DOFs once, by the evidence that is surest.
void leave_out_repeated(std::vector<Suspect>& suspects) {
  std::vector<Suspect> kept;
  for (Suspect& suspect : suspects) {
    const auto same = [&](const Suspect& other) {
      return other.kind == suspect.kind && other.file == suspect.file && other.dofs == suspect.dofs;
    };
    if (std::ranges::none_of(kept, same)) kept.push_back(std::move(suspect));
  }
  suspects = std::move(kept);
}

}  // namespace

Verdict verdict_of(const std::vector<Suspect>& suspects) {
  double surest = 0.0;
  for (const Suspect& suspect : suspects) surest = std::max(surest, suspect.confidence);
  if (suspects.empty()) return Verdict::clean;
  return surest >= 0.8 ? Verdict::wrong : Verdict::suspicious;
}

namespace {

CheckResult inquire(std::vector<CheckedFile> files, const Dofs& joint, const Surroundings& around, const Control& control,
                    bool with_axis) {
  CheckResult result;
  for (CheckedFile& file : files) {
    result.suspects.insert(result.suspects.end(), file.wild.begin(), file.wild.end());
    for (Suspect& suspect : take_out_dead_and_copied(file)) result.suspects.push_back(std::move(suspect));
    for (Suspect& suspect : find_copied_columns(file)) result.suspects.push_back(std::move(suspect));
  }
  result.notes = missing_points(files, joint);
  std::erase_if(files, [](const CheckedFile& file) { return file.responses.empty() || file.references.empty(); });
  if (!files.empty()) {
    for (Suspect& label : find_labels(files, joint)) result.suspects.push_back(std::move(label));
    for (Suspect& mass : find_wrong_masses(files, joint)) result.suspects.push_back(std::move(mass));
    Inquiry inquiry(std::move(files), joint, around, control, with_axis);
    result.reciprocity = inquiry.reciprocity();
    for (Suspect& suspect : inquiry.suspects()) result.suspects.push_back(std::move(suspect));
  }
  std::ranges::stable_sort(result.suspects, std::ranges::greater{}, &Suspect::confidence);
  leave_out_repeated(result.suspects);
  result.verdict = verdict_of(result.suspects);
  return result;
}

/// A part and what the assembly's files have of its coordinates.
struct PartFiles {
  Files files;
  double level = 0.0;  ///< the largest of its span and reciprocity tests
  bool stands_out = false;
};

constexpr std::size_t most_inquired = 16, most_references = 16;

/// The references on a part, and the strongest of the others.
Dofs references_of(const CheckedFile& assembly, const CheckedFile& part) {
  Dofs own;
  std::vector<std::pair<double, std::size_t>> others;
  std::vector<Eigen::Index> rows;
  for (const frf::Dof& dof : part.responses) {
    if (const std::size_t r = place_of(assembly.responses, dof); r != frf::npos) rows.push_back(at(r));
  }
  for (std::size_t c = 0; c < assembly.references.size(); ++c) {
    const frf::Dof& dof = assembly.references[c];
    if (place_of(part.references, dof) != frf::npos) {
      own.push_back(dof);
      continue;
    }
    double size = 0.0;
    for (const Eigen::MatrixXcd& line : assembly.frfs) {
      for (const Eigen::Index r : rows) size += std::isfinite(std::norm(line(r, at(c)))) ? std::norm(line(r, at(c))) : 0.0;
    }
    others.emplace_back(size, c);
  }
  std::ranges::stable_sort(others, std::ranges::greater{}, &std::pair<double, std::size_t>::first);
  for (std::size_t i = 0; i < std::min(most_references, others.size()); ++i) own.push_back(assembly.references[others[i].second]);
  return own;
}

/// Rows of the part alone first: cutting columns out of all rows of the assembly would cost its size for every part.
PartFiles part_files(const std::vector<CheckedFile>& files, const CheckedFile& part, const Dofs& joint, const Dofs& elsewhere) {
  PartFiles out{.files = {part}};
  for (const CheckedFile& assembly : files) {
    if (!assembly.assembly) continue;
    CheckedFile cut = part_of(assembly, part.responses, references_of(assembly, part));
    if (!cut.responses.empty() && !cut.references.empty()) out.files.push_back(std::move(cut));
  }
  for (const SpanSetup& setup : span_setups(out.files, joint, elsewhere))
    out.level = std::max(out.level, span_test(setup, out.files, SpanDetail::level).level);
  for (const CheckedFile& file : out.files) {
    out.level = std::max(out.level, reciprocity_test(file, false).level);
    CheckedFile copy = file;
    out.stands_out = out.stands_out || activity(file, noise_that_halves) > 0.0 || !take_out_dead_and_copied(copy).empty();
  }
  return out;
}

}  // namespace

CheckResult inquire(std::vector<CheckedFile> files, const Dofs& joint, const Control& control, bool with_axis) {
  return inquire(std::move(files), joint, Surroundings{}, control, with_axis);
}

CheckResult inquire_by_parts(const std::vector<CheckedFile>& files, const Dofs& joint, const Control& control, bool with_axis) {
  constexpr double large = 0.08, over_median = 2.5;
  Surroundings around{.elsewhere = {}, .chosen_from = 0};
  for (const CheckedFile& file : files) {
    if (file.assembly) around.elsewhere.insert(around.elsewhere.end(), file.references.begin(), file.references.end());
    if (!file.assembly) ++around.chosen_from;
  }
  CheckResult result;
  std::vector<PartFiles> parts;
  std::vector<double> levels;
  for (const CheckedFile& file : files) {
    stop_if(control.interrupted);
    if (file.assembly) continue;
    result.suspects.insert(result.suspects.end(), file.wild.begin(), file.wild.end());
    parts.push_back(part_files(files, file, joint, around.elsewhere));
    levels.push_back(parts.back().level);
  }
  const double usual = median(levels);
  const double high = std::min(large, std::max(over_median * usual, 0.01));
  std::erase_if(parts, [&](const PartFiles& part) { return !part.stands_out && part.level <= high; });
  std::ranges::stable_sort(parts, std::ranges::greater{}, &PartFiles::level);
  parts.resize(std::min(parts.size(), most_inquired));
  for (PartFiles& part : parts) {
    for (CheckedFile& file : part.files) file.wild.clear();
    CheckResult found = inquire(std::move(part.files), joint, around, control, with_axis);
    result.suspects.insert(result.suspects.end(), found.suspects.begin(), found.suspects.end());
    result.notes.insert(result.notes.end(), found.notes.begin(), found.notes.end());
    result.reciprocity.insert(result.reciprocity.end(), found.reciprocity.begin(), found.reciprocity.end());
  }
  std::ranges::stable_sort(result.suspects, std::ranges::greater{}, &Suspect::confidence);
  leave_out_repeated(result.suspects);
  result.verdict = verdict_of(result.suspects);
  return result;
}

}  // namespace jointid::ident
