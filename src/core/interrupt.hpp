#pragma once
// Ctrl-C and SIGTERM as a question that long work asks between two steps.

namespace platen::core {

/// From now on SIGINT and SIGTERM set a flag instead of ending the program; a second one ends it. A file that
/// may grow no further fails to be written instead of ending it.
void watch_for_interrupts();

/// Whether the user asked to stop.
bool interrupted();

} // namespace platen::core
