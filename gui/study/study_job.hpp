#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <vector>

#include "gui/work/worker.hpp"
#include "study/study.hpp"
#include "study/study_statistics.hpp"
#include "report/page/contents.hpp"
#include "report/text/table.hpp"

namespace jointid::gui {

struct StudyWish {
  ident::Scene scene;
  std::string scene_text;  ///< of the scene's file
  std::filesystem::path out;
  std::size_t trials = 1000;
  std::uint64_t seed = 1;
  bool from_the_beginning = false;  ///< an interrupted study is not taken up
};

/// Histograms that are shown together.
struct HistogramSet {
  std::string name;
  std::vector<report::HistogramPlot> plots;
};

/// What there is of a study: of the trials that this run computed while it goes on, of all of them at its end.
struct StudyShown {
  bool complete = false;
  std::size_t done = 0, trials = 0;
  std::vector<HistogramSet> histograms{};
  report::Table unknowns{{}};
  std::string text{};  ///< how the trials ended
};

/// The values of trials as they come, of the first unknowns and trials only; from any thread.
class LiveTrials {
 public:
  explicit LiveTrials(const std::vector<study::TrialUnknown>& unknowns);

  /// A row of the result file.
  void put(std::span<const double> row);
  std::vector<HistogramSet> histograms() const;

 private:
  static constexpr std::size_t most_trials = 20000, most_unknowns = 12;

  std::vector<study::TrialUnknown> unknowns_;
  mutable std::mutex mutex_;
  std::vector<std::vector<double>> values_;  ///< of each unknown
};

/// As `jointid study` does, with the same result file. `so_far` is given what there is a few times per second. Interrupted, the
/// trials that are done stay beside the result file, and the next run of the same study takes them up. Throws InputError.
StudyShown run_study_job(const StudyWish& wish, const Worker::Watch& watch, const std::function<void(const StudyShown&)>& so_far);

}  // namespace jointid::gui
