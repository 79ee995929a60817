#pragma once
// A study of the materials that are to be pressed next.

#include "study/card.hpp"
#include "surrogate/refine.hpp"

#include <filesystem>
#include <string>

namespace platen::surrogate {

/// A surrogate by the folder of its pool, or by its file.
Surrogate find_surrogate(const std::filesystem::path& pool_or_file);

struct RefinedStudy {
  std::string study; ///< whose runs were the candidates
  std::size_t candidates = 0;
  Refined refined;                   ///< which of them
  std::filesystem::path card, table; ///< written; empty: nothing to press
};

/// Writes a study of the chosen runs (refine.hpp), a card with its table beside it. `output`: the card;
/// empty: STUDY-refined.toml beside the study. InvalidInput for a study of another model, or over itself.
/// Throws Interrupted, IoError.
RefinedStudy refine_study(const study::Study&, const Surrogate&, double target, std::size_t most,
                          const std::filesystem::path& output);

/// A few lines for people.
std::string words_of(const RefinedStudy&, double target);

} // namespace platen::surrogate
