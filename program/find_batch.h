#ifndef PROGRAM_FIND_BATCH_H
#define PROGRAM_FIND_BATCH_H

#include "Options.h"

namespace Program {

/// finds the files of all meshes of a batch, in the order of the inputs, checks that no output would replace an input or another
/// output, and creates the output folder.
std::vector<File_names> find_batch(const Options& options);

} // namespace Program

#endif // PROGRAM_FIND_BATCH_H
