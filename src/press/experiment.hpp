#pragma once
// Any experiment, as its case says.

#include "press/confined.hpp"
#include "press/local.hpp"
#include "press/simple.hpp"

#include <variant>

namespace platen::press {

/// What an experiment gives: more where it knows more.
using AnyResult = std::variant<Result, LocalResult, ConfinedResult>;

/// local(), confined() or simple(); errors as theirs.
AnyResult press(const Case&, const Progress& = {});

/// What all experiments have.
inline const Result& common(const AnyResult& any) {
  return std::visit([](const auto& result) -> const Result& { return result; }, any);
}

} // namespace platen::press
