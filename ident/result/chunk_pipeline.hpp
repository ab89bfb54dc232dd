#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ident/team/line_shares.hpp"

namespace jointid::ident {

struct Control;

/// One of several workers that share the chunks of a run. read() is called by one worker at a time, work() by several at
/// once, merge() by one at a time and in the order of the chunks: what comes out does not depend on the number of workers.
class ChunkWorker {
 public:
  virtual ~ChunkWorker() = default;
  virtual void read(std::size_t first, std::size_t last) = 0;
  virtual void work(std::size_t first, std::size_t last) = 0;
  virtual void merge() = 0;
};

/// Passes lines through the workers, `chunk` at a time; one worker runs in the calling thread without any other.
/// Reports and stops between chunks as `control` says (throws Interrupted).
void run_chunks(LineShares::Range lines, std::size_t chunk, const char* stage,
                const std::vector<std::unique_ptr<ChunkWorker>>& workers, const Control& control);

/// Lines per chunk, so that a chunk's FRFs take at most about 8 MB; independent of the number of threads.
std::size_t chunk_lines(std::size_t entries_per_line);

/// Workers worth having: as many as there are chunks, and one more than `threads` (0: all cores), since one reads.
std::size_t worker_count(std::size_t lines, std::size_t chunk, std::size_t threads);

}  // namespace jointid::ident
