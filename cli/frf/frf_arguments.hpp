#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cli/options/target.hpp"
#include "records/estimate/frf_options.hpp"
#include "records/file/read_record.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct FrfArguments {
  std::vector<std::filesystem::path> files;
  records::RecordOptions read;
  std::vector<frf::Dof> references;  ///< of the force: none (as the channels say), one, or one per file
  bool shaker = false;
  records::SegmentOptions segments;
  std::optional<double> block_s;
  records::FrfOptions options;  ///< but for `segments`, which `shaker` decides
  std::optional<std::filesystem::path> output;
  Target json, csv, report;
};

/// Declares the options of `jointid frf` on its command.
void declare(CLI::App& command, FrfArguments& arguments);

/// The options of the estimate, with those of the segments. Throws InputError (usage) for a shaker without --block.
records::FrfOptions estimate_options(const FrfArguments& arguments);

}  // namespace jointid::cli
