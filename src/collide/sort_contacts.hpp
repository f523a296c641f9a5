#pragma once

#include "query/scratch.hpp"

namespace pelt::detail {

/// Puts contacts in ascending order. What is in `buffer` is lost.
void sort_contacts(Stack<Contact>& contacts, Stack<Contact>& buffer);

}  // namespace pelt::detail
