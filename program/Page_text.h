#ifndef PROGRAM_PAGE_TEXT_H
#define PROGRAM_PAGE_TEXT_H

namespace Program {

// What the build bundles from the folder page/, in pieces, of which the last one is a null pointer.
extern const char* const page_head[]; ///< before the data
extern const char* const page_tail[]; ///< behind them
extern const char* const page_fault;  ///< why there is none; empty if there is

} // namespace Program

#endif // PROGRAM_PAGE_TEXT_H
