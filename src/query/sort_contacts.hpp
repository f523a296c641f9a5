#pragma once

/// Sorts what a query has found.

#include "query/scratch.hpp"
#include "query/stack.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Sorts contacts in ascending order. Overwrites `buffer`.
void sort_contacts(Stack<Contact>& contacts, Stack<Contact>& buffer);

void sort_contacts(Stack<MovingContact>& contacts, Stack<MovingContact>& buffer);

/// Appends the contacts in `scratch.found` to `contacts`, in ascending order.
void append_sorted(Scratch& scratch, std::vector<Contact>& contacts);

/// Appends the contacts in `scratch.moving` to `contacts`, in ascending order of the triangles.
void append_sorted(Scratch& scratch, std::vector<MovingContact>& contacts);

/// Sorts numbers in ascending order. Overwrites `buffer`.
void sort_numbers(Stack<std::uint32_t>& numbers, Stack<std::uint32_t>& buffer);

}  // namespace pelt::detail
