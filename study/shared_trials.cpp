#include "study/shared_trials.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>
#include <variant>

#include "study/trial_threads.hpp"

namespace jointid::study {
namespace {

/// Rows on their way to the leader: number of the trial, how many numbers its row has, the row. Who puts waits while it is full.
class Outbox {
 public:
  void put(std::size_t trial, std::span<const double> row) {
    std::unique_lock lock(mutex_);
    taken_.wait(lock, [this] { return numbers_.size() < most_numbers; });
    numbers_.push_back(static_cast<double>(trial));
    numbers_.push_back(static_cast<double>(row.size()));
    numbers_.insert(numbers_.end(), row.begin(), row.end());
  }

  std::vector<double> take() {
    const std::lock_guard lock(mutex_);
    taken_.notify_all();
    return std::exchange(numbers_, {});
  }

 private:
  static constexpr std::size_t most_numbers = 1 << 20;

  std::mutex mutex_;
  std::condition_variable taken_;
  std::vector<double> numbers_;
};

/// Gives what an Outbox sent to keep(trial, row); how many rows they were.
template <class Keep>
std::size_t unpack(std::span<const double> numbers, const Keep& keep) {
  std::size_t rows = 0;
  for (; !numbers.empty(); ++rows) {
    const auto length = static_cast<std::size_t>(numbers[1]);
    keep(static_cast<std::size_t>(numbers[0]), numbers.subspan(2, length));
    numbers = numbers.subspan(2 + length);
  }
  return rows;
}

/// Gives the leader's ranges to all.
void share_ranges(std::vector<frf::IndexRange>& ranges, ident::Team& team) {
  std::vector<std::uint64_t> ends;
  for (const frf::IndexRange& range : ranges) ends.insert(ends.end(), {range.first, range.end});
  team.share(ends);
  ranges.clear();
  for (std::size_t i = 0; i < ends.size(); i += 2) ranges.push_back({ends[i], ends[i + 1]});
}

/// The work of a thread that makes rows and gives them to put(trial, row).
template <class Put>
MakeTrialWork rows_to(const TrialSharing& sharing, Put put) {
  return [&sharing, put]() -> TrialWork {
    return [make = sharing.maker(), put, row = std::vector<double>()](std::size_t trial) mutable {
      make(trial, row);
      put(trial, row);
    };
  };
}

bool is_interrupted(const TrialSharing& sharing) { return sharing.interrupted && sharing.interrupted(); }

std::size_t follow(std::vector<frf::IndexRange> part, ident::Team& team, const TrialSharing& sharing) {
  Outbox outbox;
  TrialThreads own(std::move(part), sharing.threads,
                   rows_to(sharing, [&outbox](std::size_t trial, std::span<const double> row) { outbox.put(trial, row); }));
  for (bool ended = false; !ended;) {
    ended = own.wait_ms(5);
    if (const std::vector<double> numbers = outbox.take(); !numbers.empty()) team.send(numbers);
    if (team.stopped() || is_interrupted(sharing)) own.stop();
  }
  team.send_end(ident::text_of_end(own.failure()));
  return own.made();
}

/// Makes its part and keeps what the others send, until they and its own threads have ended.
class Leader {
 public:
  Leader(std::vector<frf::IndexRange> part, ident::Team& team, const TrialSharing& sharing)
      : team_(team),
        sharing_(sharing),
        others_(team.size() - 1),
        own_(std::move(part), sharing.threads, rows_to(sharing, sharing.keep)) {}

  std::size_t run() {
    for (bool ended = false; !ended || others_ > 0;) {
      ended = own_.wait_ms(team_.size() > 1 ? 2 : 50);
      try {
        while (const auto message = team_.receive()) take(*message);
        if (sharing_.watch) sharing_.watch(own_.made() + received_);
      } catch (...) {
        if (!failure_) failure_ = std::current_exception();
        own_.stop();
      }
      if (is_interrupted(sharing_)) own_.stop();
      if (own_.is_stopped()) team_.stop_others();
    }
    if (failure_) std::rethrow_exception(failure_);
    if (const std::exception_ptr failure = own_.failure()) std::rethrow_exception(failure);
    return own_.made() + received_;
  }

 private:
  void take(const ident::TeamMessage& message) {
    if (const auto* end = std::get_if<ident::TeamEnd>(&message)) {
      --others_;
      if (!end->failure.empty()) std::rethrow_exception(ident::failure_elsewhere(end->failure));
    } else {
      received_ += unpack(std::get<std::vector<double>>(message), sharing_.keep);
    }
  }

  ident::Team& team_;
  const TrialSharing& sharing_;
  std::size_t received_ = 0, others_;
  std::exception_ptr failure_;
  TrialThreads own_;
};

}  // namespace

std::size_t share_trials(std::vector<frf::IndexRange> missing, ident::Team& team, const TrialSharing& sharing) {
  share_ranges(missing, team);
  std::vector<frf::IndexRange> part = part_of(missing, team.rank(), team.size());
  return team.rank() == 0 ? Leader(std::move(part), team, sharing).run() : follow(std::move(part), team, sharing);
}

}  // namespace jointid::study
