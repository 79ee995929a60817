#pragma once

#include <string>
#include <string_view>

namespace platen::core {

/// SHA-256 (FIPS 180-4) as 64 hexadecimal digits: the fingerprint of a curve, the key of a run.
std::string sha256(std::string_view);

} // namespace platen::core
