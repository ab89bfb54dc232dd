#pragma once

#include <atomic>
#include <barrier>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "ident/team/team.hpp"

namespace jointid::ident {

/// A team of threads instead of processes.
class ThreadTeam {
 public:
  explicit ThreadTeam(std::size_t size) : size_(size), all_(size), meeting_(static_cast<std::ptrdiff_t>(size)) {}

  /// Runs `work` for every member at once; what it threw, null where it did not.
  std::vector<std::exception_ptr> run(const std::function<void(Team& member)>& work) {
    std::vector<std::exception_ptr> thrown(size_);
    std::vector<std::jthread> threads;
    for (std::size_t rank = 0; rank < size_; ++rank) {
      threads.emplace_back([this, rank, &work, &thrown] {
        Member member(*this, rank);
        try {
          work(member);
        } catch (...) {
          thrown[rank] = std::current_exception();
        }
      });
    }
    threads.clear();
    return thrown;
  }

 private:
  class Member final : public Team {
   public:
    Member(ThreadTeam& team, std::size_t rank) : team_(team), rank_(rank) {}

    std::size_t rank() const override { return rank_; }
    std::size_t size() const override { return team_.size_; }

    std::vector<std::vector<double>> gathered(const std::vector<double>& own) override {
      team_.all_[rank_] = own;
      team_.meeting_.arrive_and_wait();
      const auto all = team_.all_;
      team_.meeting_.arrive_and_wait();
      return all;
    }

    std::size_t first_failed(bool failed) override {
      const auto all = gathered({failed ? 1.0 : 0.0});
      for (std::size_t rank = 0; rank < all.size(); ++rank) {
        if (all[rank].front() > 0.0) return rank;
      }
      return size();
    }

    void share(std::vector<std::uint64_t>& numbers) override {
      const auto all = gathered({numbers.begin(), numbers.end()});
      numbers.clear();
      for (const double number : all.front()) numbers.push_back(static_cast<std::uint64_t>(number));
    }

    void send(const std::vector<double>& numbers) override { put(numbers); }
    void send_end(const std::string& failure) override { put(TeamEnd{failure}); }
    std::optional<TeamMessage> receive() override {
      const std::scoped_lock lock(team_.mutex_);
      if (team_.messages_.empty()) return std::nullopt;
      TeamMessage first = std::move(team_.messages_.front());
      team_.messages_.pop_front();
      return first;
    }
    void stop_others() override { team_.stops_ = true; }
    bool stopped() override { return team_.stops_; }

   private:
    void put(TeamMessage message) {
      const std::scoped_lock lock(team_.mutex_);
      team_.messages_.push_back(std::move(message));
    }

    ThreadTeam& team_;
    std::size_t rank_;
  };

  std::size_t size_;
  std::vector<std::vector<double>> all_;
  std::barrier<> meeting_;
  std::mutex mutex_;
  std::deque<TeamMessage> messages_;
  std::atomic<bool> stops_ = false;
};

}  // namespace jointid::ident
