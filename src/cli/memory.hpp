/// Memory of the command's process.
#pragma once

namespace thalweg::cli {

/// Lets memory that is given back be used again, and has it come in huge pages: each page that is touched for
/// the first time costs a visit to the system, with small pages a tenth of the time of a command. For a
/// process that soon ends, since it keeps the memory until then. Does nothing where the allocator is not
/// glibc's, or is the address sanitizer's.
void keep_freed_memory() noexcept;

}  // namespace thalweg::cli
