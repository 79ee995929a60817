#include "core/interrupt.hpp"

/// A page sends no signals.
bool platen::core::interrupted() { return false; }
void platen::core::stop_if_asked() {}
