#pragma once
// Ctrl-C and SIGTERM as a question that long work asks between two steps.

namespace platen::core {

/// From now on SIGINT and SIGTERM set a flag instead of ending the program; a second one ends it. A file that
/// may grow no further fails to be written instead of ending it.
void watch_for_interrupts();

/// A host with signals of its own, Python, is asked instead.
void ask_for_interrupts(bool (*host)());

/// Whether the user asked to stop.
bool interrupted();

/// Throws Interrupted if so: for work that has written nothing yet.
void stop_if_asked();

} // namespace platen::core
