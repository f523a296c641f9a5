"""check_exports.py names what a library should export and does not, and what it should not and does.

    check_exports_test.py CHECKER NM COMPILER INCLUDE_FOLDER
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER, NM, COMPILER, INCLUDE = sys.argv[1:5]

HEADER = """
#include <pelt/config.hpp>
namespace pelt {
namespace detail { struct State; }
struct Options { int count = 1; double limits[2] = {0, 1}; };  // f(int);
PELT_API int query(int a, const Options& options = {});
PELT_API int query(double a);
class PELT_API Body {
 public:
  Body();
  ~Body();
  int size() const;
  int twice() const { return 2 * size(); }
  Body& operator=(const Body&) = delete;
 private:
  detail::State* state_ = nullptr;
};
template <typename T> struct Box { T get() const; };
}  // namespace pelt
"""

LIBRARY = """
namespace pelt {
int helper();
int helper() { return 1; }
int query(int, const Options& options) { return options.count + helper(); }
int query(double) { return 0; }
Body::Body() {}
Body::~Body() {}
int Body::size() const { return twice(); }
}  // namespace pelt
"""


class CheckExports(unittest.TestCase):
    def check(self, header=HEADER, library=LIBRARY, flags=("-fvisibility=hidden",)):
        with tempfile.TemporaryDirectory() as folder:
            header_file, shared = pathlib.Path(folder, "body.hpp"), pathlib.Path(folder, "body.so")
            header_file.write_text(header)
            subprocess.run([COMPILER, "-x", "c++", "-std=c++20", "-shared", "-fPIC",
                            "-fvisibility-inlines-hidden",
                            *flags, f"-I{INCLUDE}", "-o", shared, "-"], input=header + library,
                           text=True, check=True)
            run = subprocess.run([sys.executable, "-B", CHECKER, NM, shared, header_file],
                                 capture_output=True, text=True)
            return run.returncode, run.stdout.splitlines()

    def test_an_exact_interface_passes(self):
        self.assertEqual(self.check(), (0, ["5 public functions, 5 exported"]))

    def test_what_is_not_hidden_is_named(self):
        status, lines = self.check(flags=())
        self.assertEqual((status, lines[:-1]), (1, ["not public: pelt::helper"]))

    def test_what_is_not_marked_is_named(self):
        status, lines = self.check(HEADER.replace("PELT_API int query(double", "int query(double"))
        self.assertEqual((status, lines[:-1]), (1, ["not exported: pelt::query",
                                                    "not marked PELT_API: pelt::query"]))

    def test_what_is_not_defined_is_named(self):
        status, lines = self.check(library=LIBRARY.replace("Body::~Body() {}", ""))
        self.assertEqual((status, lines[:-1]), (1, ["not exported: pelt::Body::~Body"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
