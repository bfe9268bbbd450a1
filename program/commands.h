#ifndef PROGRAM_COMMANDS_H
#define PROGRAM_COMMANDS_H

#include "Options.h"

namespace Program {

/// The exit status of the program if a map was written that is not one-to-one.
constexpr int exit_status_folded = 2;

/// Each runs a command and returns the exit status.
///
/// \throws Program_error if that is not to be done

/// `map`, `match`, `register`, `remesh`, `repair` and `show`
int run_map(const Options& options);
int run_check(const Options& options);
int run_batch(const Options& options);
int run_resample(const Options& options);

} // namespace Program

#endif // PROGRAM_COMMANDS_H
