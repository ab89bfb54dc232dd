#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <numeric>

#include "ident/team/team.hpp"

namespace jointid::ident {
namespace {

enum Tag : int { numbers_tag = 1, end_tag, stop_tag };

/// A message that is there for us, or nothing.
std::optional<MPI_Status> arrived(int source, int tag) {
  int flag = 0;
  MPI_Status status;
  MPI_Iprobe(source, tag, MPI_COMM_WORLD, &flag, &status);
  if (flag == 0) return std::nullopt;
  return status;
}

class MpiTeam final : public Team {
 public:
  MpiTeam() {
    int provided = 0, rank = 0, size = 1;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    rank_ = static_cast<std::size_t>(rank);
    size_ = static_cast<std::size_t>(size);
    told_.resize(size_, false);
  }
  ~MpiTeam() override { MPI_Finalize(); }

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return size_; }

  std::size_t first_failed(bool failed) override {
    std::uint64_t mine = failed ? rank_ : size_, first = 0;
    MPI_Allreduce(&mine, &first, 1, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
    return first;
  }

  void share(std::vector<std::uint64_t>& numbers) override {
    std::uint64_t count = numbers.size();
    MPI_Bcast(&count, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    numbers.resize(count);
    MPI_Bcast(numbers.data(), static_cast<int>(count), MPI_UINT64_T, 0, MPI_COMM_WORLD);
  }

  std::vector<std::vector<double>> gathered(const std::vector<double>& own) override {
    std::vector<int> counts(size_), places(size_);
    int count = static_cast<int>(own.size());
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
    std::exclusive_scan(counts.begin(), counts.end(), places.begin(), 0);
    std::vector<double> all(static_cast<std::size_t>(places.back() + counts.back()));
    MPI_Allgatherv(own.data(), count, MPI_DOUBLE, all.data(), counts.data(), places.data(), MPI_DOUBLE, MPI_COMM_WORLD);
    std::vector<std::vector<double>> out;
    for (std::size_t rank = 0; rank < size_; ++rank) {
      const auto first = all.begin() + places[rank];
      out.emplace_back(first, first + counts[rank]);
    }
    return out;
  }

  void send(const std::vector<double>& numbers) override {
    MPI_Send(numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, 0, numbers_tag, MPI_COMM_WORLD);
  }

  void send_end(const std::string& failure) override {
    MPI_Send(failure.data(), static_cast<int>(failure.size()), MPI_CHAR, 0, end_tag, MPI_COMM_WORLD);
    // Takes a request to stop that crossed this message, so that none is left over.
    char none = 0;
    MPI_Recv(&none, 1, MPI_CHAR, 0, stop_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  }

  std::optional<TeamMessage> receive() override {
    if (const auto status = arrived(MPI_ANY_SOURCE, numbers_tag)) {
      int count = 0;
      MPI_Get_count(&*status, MPI_DOUBLE, &count);
      std::vector<double> numbers(static_cast<std::size_t>(count));
      MPI_Recv(numbers.data(), count, MPI_DOUBLE, status->MPI_SOURCE, numbers_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      return numbers;
    }
    if (const auto status = arrived(MPI_ANY_SOURCE, end_tag)) {
      int count = 0;
      MPI_Get_count(&*status, MPI_CHAR, &count);
      TeamEnd end{std::string(static_cast<std::size_t>(count), ' ')};
      MPI_Recv(end.failure.data(), count, MPI_CHAR, status->MPI_SOURCE, end_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      if (!told_[static_cast<std::size_t>(status->MPI_SOURCE)]) tell_stop(status->MPI_SOURCE);
      return end;
    }
    return std::nullopt;
  }

  void stop_others() override {
    if (stopping_) return;
    stopping_ = true;
    for (std::size_t other = 1; other < size_; ++other) {
      if (!told_[other]) tell_stop(static_cast<int>(other));
    }
  }

  bool stopped() override { return arrived(0, stop_tag).has_value(); }

 private:
  /// Everyone is told once: when it is to stop, or after it ended.
  void tell_stop(int other) {
    const char none = 0;
    told_[static_cast<std::size_t>(other)] = true;
    MPI_Send(&none, 1, MPI_CHAR, other, stop_tag, MPI_COMM_WORLD);
  }

  std::size_t rank_ = 0, size_ = 1;
  bool stopping_ = false;
  std::vector<bool> told_;
};

class Mpi final : public MpiModule {
 public:
  std::unique_ptr<Team> join() override { return std::make_unique<MpiTeam>(); }
};

}  // namespace
}  // namespace jointid::ident

extern "C" void* jointid_module() {
  static jointid::ident::Mpi module;
  return static_cast<jointid::ident::MpiModule*>(&module);
}
