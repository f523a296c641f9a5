#!/usr/bin/env python3
"""Checks that a shared library exports its public interface and nothing else of Pelt.

    check_exports.py NM LIBRARY HEADERS...

Public are the functions that the headers declare and do not define. Each must be marked PELT_API, or
be a member of a marked class, and be exported once for each of its declarations. Templates of the
standard library that the compiler has instantiated are not of Pelt; their copies in several libraries
are equal.
"""

import collections
import pathlib
import re
import subprocess
import sys

OPENS_NAMESPACE = re.compile(r"(?:inline )?namespace ([\w:]*)$")
OPENS_CLASS = re.compile(r"(?:template <.*> )?(?:class|struct) (?:\[\[\w+\]\] )?(PELT_API )?(\w+)(?:<.*>)?(?: :.*)?$")
FUNCTION = re.compile(r"([^=(]*?)(~?\w+|operator ?[^\w\s(]+) ?\(")
NO_FUNCTION = ("}", "friend ", "static_assert", "using ")
DEFINED = ("= default", "= delete")
MANGLED = re.compile(r"_Z(?:T[VTISC]|GV|Z)*N?[KRO]*4pelt")


class Declared:
    """The functions that a header declares and does not define: `all` of them, and those `unmarked`."""

    def __init__(self, text):
        self.all, self.unmarked = [], []
        text = re.sub(r"//[^\n]*|^ *#[^\n]*(?:\\\n[^\n]*)*", "", text, flags=re.M)
        self.rest = " ".join(text.split())
        self.read_scope([], False)

    def read_scope(self, names, marked):
        """Reads up to the brace that closes the scope."""
        statement = ""
        while self.rest:
            plain, sign, self.rest = re.match(r"([^{};]*)([{};]?)(.*)", self.rest).groups()
            statement = re.sub(r"^(?:public|private|protected) ?: ?", "", (statement + plain).strip())
            if sign == "}":
                return
            if sign == ";":
                self.add_statement(statement, names, marked)
                statement = ""
            elif sign == "{":
                statement = self.read_braces(statement, names, marked)

    def read_braces(self, statement, names, marked):
        """Reads a scope or a body; returns what the statement goes on with."""
        if match := OPENS_NAMESPACE.match(statement):
            self.read_scope([*names, *filter(None, match[1].split("::"))], False)
            return ""
        if match := OPENS_CLASS.match(statement):
            # A template is defined in its header.
            skipped = Declared("") if statement.startswith("template") else self
            skipped.rest = self.rest
            skipped.read_scope([*names, match[2]], bool(match[1]))
            self.rest = skipped.rest
            return "}"
        depth = 1
        while depth > 0:
            sign, self.rest = re.match(r"[^{}]*([{}])(.*)", self.rest).groups()
            depth += 1 if sign == "{" else -1
        # The body of a function ends the statement; an initialiser or a default argument does not.
        is_body = "(" in statement and statement.count("(") == statement.count(")")
        return "" if is_body and "=" not in statement.split("(")[0] else statement + " {}"

    def add_statement(self, statement, names, marked):
        match = FUNCTION.match(statement)
        if (not match or match[1].count("<") != match[1].count(">") or
                statement.startswith(NO_FUNCTION) or statement.endswith(DEFINED)):
            return
        name = "::".join([*names, match[2]])
        self.all.append(name)
        if not marked and "PELT_API" not in match[1].split():
            self.unmarked.append(name)


def exported_by(nm, library):
    """The names of Pelt's exported symbols without parameters, one for each function."""
    command = [nm, "--dynamic", "--defined-only", "--no-sort", "--format=posix"]
    listings = [subprocess.run([*command, *options, library], capture_output=True, text=True,
                               check=True).stdout.splitlines() for options in ([], ["--demangle"])]
    signatures = {re.sub(r" \w( [0-9a-f]+){0,2}$", "", plain)
                  for mangled, plain in zip(*listings) if MANGLED.match(mangled)}
    # Constructors and destructors have several symbols with one signature.
    return [re.sub(r"(\[abi:\w+\])?\(.*", "", signature) for signature in signatures]


def main(nm, library, *headers):
    declared = [Declared(pathlib.Path(header).read_text()) for header in headers]
    public = collections.Counter(name for header in declared for name in header.all)
    exported = collections.Counter(exported_by(nm, library))
    complaints = [f"not marked PELT_API: {name}" for header in declared for name in header.unmarked]
    complaints += [f"not exported: {name}" for name in (public - exported).elements()]
    complaints += [f"not public: {name}" for name in (exported - public).elements()]
    print(*sorted(complaints), f"{public.total()} public functions, {exported.total()} exported", sep="\n")
    return 1 if complaints or not public else 0


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
