#pragma once
// Surrogates, their methods and sensitivities in words, as tables for people.

#include "surrogate/methods.hpp"
#include "surrogate/rock.hpp"
#include "surrogate/sobol.hpp"
#include "surrogate/surrogate.hpp"

#include <string>

namespace platen::surrogate {

/// What it is made of, and its errors. `file`: where it is. `pools`: of which it was made just now, where
/// they are at hand; they say what was left aside.
std::string words_of(const Surrogate&, const std::string& file, const Pools* pools = nullptr);
std::string words_of(const Rock&, const std::string& file);
std::string words_beside(const Rock&, const Rock& other);

/// How well it says what a pool that it is not made of pressed.
std::string words_beside(const Surrogate&, const PoolData& other);

/// Ways to predict, side by side. `pool`: of which materials.
std::string words_of(const Methods&, const std::string& pool);
std::string words_of(const Rock&, const std::vector<RockMethod>&);

/// Sobol indices of a material.
std::string words_of(const Sensitivity&, const std::string& material, double within);

} // namespace platen::surrogate
