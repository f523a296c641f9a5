#pragma once

/// `PELT_TRY { ... } PELT_CATCH_ALL { ... }`, which also compiles without exceptions: the second
/// block is then never run. The library throws nothing itself; the standard library throws when
/// memory or threads end.
#if defined(__cpp_exceptions)
#define PELT_TRY try
#define PELT_CATCH_ALL catch (...)
#else
#define PELT_TRY
#define PELT_CATCH_ALL if constexpr (false)
#endif
