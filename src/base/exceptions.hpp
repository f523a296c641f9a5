#pragma once

/// `PELT_TRY { ... } PELT_CATCH_ALL { ... }`, or `PELT_CATCH(std::bad_alloc) { ... }`, which also
/// compile without exceptions: the second block is then never run. The library throws nothing
/// itself; the standard library throws when memory or threads end.
#if defined(__cpp_exceptions)
#define PELT_TRY try
#define PELT_CATCH_ALL catch (...)
#define PELT_CATCH(type) catch (const type&)
#else
#define PELT_TRY
#define PELT_CATCH_ALL if constexpr (false)
#define PELT_CATCH(type) if constexpr (false)
#endif
