#include "ident/result/chunk_pipeline.hpp"

#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>
#include <complex>
#include <mutex>

#include "base/parallel.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {
namespace {

struct Chunk {
  ChunkWorker* worker = nullptr;
  std::size_t first = 0, last = 0;
};

/// Hands out chunks one after the other, reporting and stopping in between.
class Source {
 public:
  Source(LineShares::Range lines, std::size_t chunk, const char* stage, const Control& control)
      : lines_(lines), next_(lines.first), chunk_(chunk), stage_(stage), control_(control) {}

  bool next(Chunk& out) {
    if (next_ >= lines_.last) return false;
    stop_if(control_.interrupted);
    if (control_.progress) control_.progress(stage_, next_ - lines_.first, lines_.size());
    out.first = next_;
    out.last = std::min(next_ + chunk_, lines_.last);
    next_ = out.last;
    return true;
  }

 private:
  LineShares::Range lines_;
  std::size_t next_, chunk_;
  const char* stage_;
  const Control& control_;
};

/// Workers that wait for a chunk. There are as many as chunks in flight, so one is always free.
class FreeWorkers {
 public:
  explicit FreeWorkers(const std::vector<std::unique_ptr<ChunkWorker>>& workers) {
    for (const auto& worker : workers) free_.push_back(worker.get());
  }
  ChunkWorker* take() {
    const std::lock_guard lock(mutex_);
    ChunkWorker* worker = free_.back();
    free_.pop_back();
    return worker;
  }
  void give_back(ChunkWorker* worker) {
    const std::lock_guard lock(mutex_);
    free_.push_back(worker);
  }

 private:
  std::mutex mutex_;
  std::vector<ChunkWorker*> free_;
};

void run_in_turn(Source& source, ChunkWorker& worker) {
  Chunk chunk;
  while (source.next(chunk)) {
    worker.read(chunk.first, chunk.last);
    worker.work(chunk.first, chunk.last);
    worker.merge();
  }
}

}  // namespace

void run_chunks(LineShares::Range lines, std::size_t chunk, const char* stage,
                const std::vector<std::unique_ptr<ChunkWorker>>& workers, const Control& control) {
  Source source(lines, chunk, stage, control);
  if (workers.size() == 1) {
    run_in_turn(source, *workers.front());
    return;
  }
  FreeWorkers free(workers);
  using oneapi::tbb::filter_mode;
  oneapi::tbb::parallel_pipeline(
      workers.size(),
      oneapi::tbb::make_filter<void, Chunk>(filter_mode::serial_in_order,
                                            [&](oneapi::tbb::flow_control& flow) {
                                              Chunk next;
                                              if (!source.next(next)) {
                                                flow.stop();
                                                return next;
                                              }
                                              next.worker = free.take();
                                              next.worker->read(next.first, next.last);
                                              return next;
                                            }) &
          oneapi::tbb::make_filter<Chunk, Chunk>(filter_mode::parallel,
                                                 [](Chunk next) {
                                                   next.worker->work(next.first, next.last);
                                                   return next;
                                                 }) &
          oneapi::tbb::make_filter<Chunk, void>(filter_mode::serial_in_order, [&](Chunk next) {
            next.worker->merge();
            free.give_back(next.worker);
          }));
}

std::size_t chunk_lines(std::size_t entries_per_line) {
  constexpr std::size_t chunk_bytes = 1u << 20;  // what is read is still in the cache when it is worked on
  const std::size_t line_bytes = std::max<std::size_t>(1, entries_per_line * sizeof(std::complex<double>));
  return std::max<std::size_t>(1, chunk_bytes / line_bytes);
}

std::size_t worker_count(std::size_t lines, std::size_t chunk, std::size_t threads) {
  const std::size_t chunks = (lines + chunk - 1) / chunk;
  if (chunks <= 1) return 1;  // to count cores opens a file of the system
  const std::size_t used = threads_or_cores(threads);
  return used == 1 ? 1 : std::min(chunks, used + 1);
}

}  // namespace jointid::ident
