#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "models/model.hpp"
#include "models/model_dofs.hpp"

namespace jointid::models {

/// A model with names.
struct NamedModel {
  std::string file;  ///< for messages
  std::shared_ptr<Model> model;
  NamedCoordinates coordinates;
  double noise = 0.0;  ///< standard deviation of an FRF's complex error over its size; 0: the model is exact
  std::vector<frf::Node> nodes{};
};

/// FRFs of a model at lines that others have: each block that is read is computed, and nothing else. Every DOF is response and
/// reference. Variances are (noise·|H|)²/2 of real and imaginary part, 0 of an exact model.
class ModelSource final : public frf::FrfSource {
 public:
  /// Throws InputError as frf::validate().
  ModelSource(NamedModel named, std::vector<double> frequency_hz);

  const ModelCount& model_count() const { return named_.model->count(); }

 private:
  void announce(const frf::Block& block, const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns);
  void do_read(const frf::Block& block, std::span<Complex> out) override;
  void do_read_variance(const frf::Block& block, std::span<Complex> out) override;
  void do_read_coherence(const frf::Block& block, std::span<double> out) override;

  NamedModel named_;
  /// The block that was read last, whose variances may be asked for next.
  std::vector<std::size_t> last_lines_, last_responses_, last_references_;
  std::vector<Complex> last_;
};

/// Whether FRFs are those of a model: behind their variances stand infinitely many averages.
bool is_model(const frf::FrfHeader& header);

}  // namespace jointid::models
