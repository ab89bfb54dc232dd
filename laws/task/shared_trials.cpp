#include "laws/task/shared_trials.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <sstream>
#include <thread>
#include <utility>

#include "base/control.hpp"
#include "base/parallel.hpp"

namespace jointid::laws {
namespace {

using TrialNumbers = std::vector<std::uint64_t>;

/// What the leader has of a study.
class KnownTrials {
 public:
  explicit KnownTrials(const LawStudyOptions& options) : options_(options), trials_(options.trials), is_known_(options.trials) {
    for (const LawTrial& trial : options.known) {
      if (trial.trial < trials_.size()) keep(trial);
    }
  }

  TrialNumbers missing() const {
    TrialNumbers out;
    for (std::size_t trial = 0; trial < trials_.size(); ++trial) {
      if (!is_known_[trial]) out.push_back(trial);
    }
    return out;
  }

  void put(const LawTrial& trial) {
    const std::scoped_lock lock(mutex_);
    keep(trial);
    if (options_.made) options_.made(trial);
    if (options_.progress) options_.progress(count_, trials_.size());
  }

  std::vector<LawTrial> all() { return std::move(trials_); }

 private:
  void keep(const LawTrial& trial) {
    trials_[trial.trial] = trial;
    if (!is_known_[trial.trial]) ++count_;
    is_known_[trial.trial] = true;
  }

  const LawStudyOptions& options_;
  std::vector<LawTrial> trials_;
  std::vector<bool> is_known_;
  std::size_t count_ = 0;
  std::mutex mutex_;
};

TrialNumbers part_of(const TrialNumbers& missing, const ident::Team& team) {
  TrialNumbers out;
  for (std::size_t i = team.rank(); i < missing.size(); i += team.size()) out.push_back(missing[i]);
  return out;
}

/// A process's own trials, made on threads beside the one that speaks with the other processes.
class OwnTrials {
 public:
  using Put = std::function<void(const LawTrial& trial)>;

  OwnTrials(TrialNumbers numbers, const MakeTrial& make, const LawStudyOptions& options, Put put)
      : numbers_(std::move(numbers)), make_(make), options_(options), put_(std::move(put)) {}

  void start() {
    thread_ = std::jthread([this] {
      try {
        run();
      } catch (...) {
        failure_ = std::current_exception();
      }
      has_ended_ = true;
    });
  }

  void run() {
    for_each_index(numbers_.size(), options_.threads, [&](std::size_t i) {
      if (is_stopped()) throw Interrupted();
      put_(make_(numbers_[i]));
    });
  }

  void stop() { stops_ = true; }
  bool is_stopped() const { return stops_ || (options_.interrupted && options_.interrupted()); }
  bool has_ended() const { return has_ended_; }
  std::exception_ptr failure() const { return failure_; }  ///< once they have ended

 private:
  TrialNumbers numbers_;
  const MakeTrial& make_;
  const LawStudyOptions& options_;
  Put put_;
  std::atomic<bool> stops_ = false, has_ended_ = false;
  std::exception_ptr failure_;
  std::jthread thread_;
};

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

/// Trials on their way to the leader as numbers, which is what teams send: the bytes of their lines.
class Post {
 public:
  explicit Post(std::size_t values) : values_(values) {}

  void put(const LawTrial& trial) {
    const std::scoped_lock lock(mutex_);
    lines_ += line_of(trial, values_);
  }

  std::vector<double> take() {
    const std::scoped_lock lock(mutex_);
    const std::vector<double> out(lines_.begin(), lines_.end());
    lines_.clear();
    return out;
  }

 private:
  std::size_t values_;
  std::mutex mutex_;
  std::string lines_;
};

std::vector<LawTrial> opened(const std::vector<double>& sent, std::size_t values) {
  std::string lines;
  for (const double byte : sent) lines.push_back(static_cast<char>(byte));
  std::vector<LawTrial> out;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) out.push_back(*trial_of(line, values));
  return out;
}

void follow(const MakeTrial& make, std::size_t values, const LawStudyOptions& options, ident::Team& team) {
  TrialNumbers missing;
  team.share(missing);
  Post post(values);
  OwnTrials own(part_of(missing, team), make, options, [&](const LawTrial& trial) { post.put(trial); });
  own.start();
  for (bool ended = false; !ended;) {
    ended = own.has_ended();
    if (const std::vector<double> lines = post.take(); !lines.empty()) team.send(lines);
    if (team.stopped()) own.stop();
    wait_a_little();
  }
  team.send_end(ident::text_of_end(own.failure()));
}

/// Takes what the others send until they and the own trials have ended.
class Leader {
 public:
  Leader(KnownTrials& known, OwnTrials& own, std::size_t values, ident::Team& team)
      : known_(known), own_(own), values_(values), team_(team), others_(team.size() - 1) {}

  void run() {
    while (!own_.has_ended() || others_ > 0) {
      while (const auto message = team_.receive()) take(*message);
      if (own_.has_ended() && own_.failure()) own_.stop();
      if (own_.is_stopped()) team_.stop_others();
      wait_a_little();
    }
    if (failure_) std::rethrow_exception(failure_);
    if (own_.failure()) std::rethrow_exception(own_.failure());
  }

 private:
  void take(const ident::TeamMessage& message) {
    try {
      if (const auto* end = std::get_if<ident::TeamEnd>(&message)) {
        --others_;
        if (!end->failure.empty()) std::rethrow_exception(ident::failure_elsewhere(end->failure));
      } else {
        for (const LawTrial& trial : opened(std::get<std::vector<double>>(message), values_)) known_.put(trial);
      }
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
      own_.stop();
    }
  }

  KnownTrials& known_;
  OwnTrials& own_;
  std::size_t values_;
  ident::Team& team_;
  std::size_t others_;
  std::exception_ptr failure_;
};

}  // namespace

std::optional<std::vector<LawTrial>> trials_made_together(const MakeTrial& make, std::size_t values,
                                                          const LawStudyOptions& options, ident::Team& team) {
  if (team.rank() != 0) {
    follow(make, values, options, team);
    return std::nullopt;
  }
  KnownTrials known(options);
  TrialNumbers missing = known.missing();
  team.share(missing);
  OwnTrials own(part_of(missing, team), make, options, [&](const LawTrial& trial) { known.put(trial); });
  if (team.size() == 1) {
    own.run();
  } else {
    own.start();
    Leader(known, own, values, team).run();
  }
  stop_if(options.interrupted);
  return known.all();
}

}  // namespace jointid::laws
