#pragma once

#include "query/scratch.hpp"

#include <vector>

namespace pelt::detail {

/// Puts contacts in ascending order. What is in `buffer` is lost.
void sort_contacts(Stack<Contact>& contacts, Stack<Contact>& buffer);

/// Appends the contacts in `scratch.found` to `contacts`, in ascending order.
void append_sorted(Scratch& scratch, std::vector<Contact>& contacts);

}  // namespace pelt::detail
