#include <hybridfusion/core/memory.hpp>

#include <malloc.h>

namespace hybridfusion {

void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace hybridfusion
