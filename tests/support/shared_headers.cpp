#include "support/shared_headers.hpp"
