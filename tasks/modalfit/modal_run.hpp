#pragma once

#include <complex>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "frf/uff/uff55.hpp"
#include "ident/scene/scene.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/symmetric_model.hpp"
#include "modalfit/model/synthesis.hpp"

namespace jointid::tasks {

/// A modal fit and what is told of it: what `jointid modalfit` found.
struct ModalRun {
  std::string files;  ///< as named by the user
  frf::FrfHeader header;
  modalfit::Band band;     ///< the receptances that were fitted, m/N, [response × reference, line]
  modalfit::ModalFit fit;  ///< poles (Hz, damping ratios or loss factors) with standard deviations, residues, status
  std::optional<modalfit::SymmetricModel> symmetric;
  std::string obstacle;     ///< why there is no symmetric model
  frf::FrfSet regenerated;  ///< the band's lines and entries, by the symmetric model where there is one
  std::vector<modalfit::SynthesisError> of_fit, of_model;  ///< per entry; of_model is empty without a symmetric model
  double read_s = 0.0, fit_s = 0.0;                        ///< seconds that reading and fitting took
};

/// Fits the FRFs of a set and judges the fit. Stopped by `options.interrupted` it gives the modes found so far, marked so, and
/// throws Interrupted where there are none. Throws InputError as modalfit::make_band().
ModalRun run_modal(const std::string& name, const frf::FrfSet& set, const modalfit::FitOptions& options);

/// The same of the files of one structure (frf::open_as_one()), named by them.
ModalRun run_modal_files(const std::vector<std::filesystem::path>& files, const frf::OpenOptions& open,
                         const modalfit::FitOptions& options);

/// All FRFs of the files of a structure, corrected as a scene says, repeats as their mean. Throws InputError.
frf::FrfSet load_structure(const std::vector<ident::DataFile>& files);

/// Shapes over some coordinates, one per mode: those of the symmetric model, else the residues of the reference with the largest
/// ones (of arbitrary scale).
struct Shapes {
  std::vector<frf::Dof> dofs;
  std::vector<std::vector<std::complex<double>>> of_mode;
};
Shapes shapes(const ModalRun& run);

/// The modes as dataset 55 has them (docs/modal-models.md).
std::vector<frf::Uff55Mode> uff_modes(const ModalRun& run);

/// What `jointid modalfit` writes for --regenerate and --shapes. Throw InputError.
void write_regenerated(const ModalRun& run, const std::filesystem::path& path);
void write_shapes(const ModalRun& run, const std::filesystem::path& path);

}  // namespace jointid::tasks
