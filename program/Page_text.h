#ifndef PROGRAM_PAGE_TEXT_H
#define PROGRAM_PAGE_TEXT_H

namespace Program {

// The files of the folder page/, bundled by the build as pieces that end with a null pointer.
extern const char* const page_head[]; ///< before the data
extern const char* const page_tail[]; ///< after the data
extern const char* const page_fault;  ///< the reason why there is no page; empty if there is one

} // namespace Program

#endif // PROGRAM_PAGE_TEXT_H
