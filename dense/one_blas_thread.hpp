#pragma once

extern "C" [[gnu::weak]] void openblas_set_num_threads(int);

namespace jointid::dense {

/// For modules whose library calls BLAS: where the machine's BLAS is OpenBLAS with threads, it uses one, as lines and trials are
/// what threads share here, and sums keep their order.
inline void use_one_blas_thread() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
}

}  // namespace jointid::dense
