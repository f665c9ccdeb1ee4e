#pragma once

namespace hybridfusion {

/// Gives memory that was freed back to the system: between stages of large and different needs, of
/// which the allocator would else keep the sum. Does nothing where the C library is not GNU's.
void return_freed_memory();

}  // namespace hybridfusion
