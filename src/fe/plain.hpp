#pragma once
// A build without what makes the solver fast, -DPLATEN_PLAIN=ON, for a test that the answers do not rest on
// it: each tangent is factorised, in double precision, without LAPACK, for any processor.

namespace platen::fe {

#ifdef PLATEN_PLAIN
using Factor = double;
inline constexpr bool plain = true;
#else
using Factor = float;
inline constexpr bool plain = false;
#endif

} // namespace platen::fe
