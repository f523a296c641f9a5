"""check_readme.py accepts correct documents and rejects each kind of error."""

import pathlib
import tempfile
import unittest

import check_readme

PROGRAM = "int main() {}\n"


class CheckReadme(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        (self.folder / "a.cpp").write_text(PROGRAM)

    def document(self, text, name="README.md"):
        document = self.folder / name
        document.write_text(text)
        return document

    def programs(self, *texts):
        documents = [self.document(text, f"{i}.md") for i, text in enumerate(texts)]
        count, wrong = check_readme.check_programs(self.folder, *documents)
        return count, len(wrong)

    def commands(self, text):
        count, wrong = check_readme.check_commands(self.document(text), self.folder)
        return count, len(wrong)

    def links(self, text):
        count, wrong = check_readme.check_links(self.document(text))
        return count, len(wrong)

    def test_a_program_is_shown_to_the_letter(self):
        self.assertEqual(self.programs(f"# A\n\n```cpp\n{PROGRAM}```\n"), (1, 0))

    def test_a_changed_program_is_wrong_and_the_example_missing(self):
        self.assertEqual(self.programs("```cpp\nint main() { }\n```\n"), (1, 2))

    def test_each_example_is_shown_by_one_of_the_documents(self):
        shown = f"```cpp\n{PROGRAM}```\n"
        self.assertEqual(self.programs("", shown), (1, 0))
        self.assertEqual(self.programs("", ""), (0, 1))

    def test_a_marked_block_may_be_a_part(self):
        (self.folder / "a.cpp").write_text("int main() {\n  f();\n  g();\n}\n")
        self.assertEqual(self.programs("<!-- part -->\n```cpp\nf();\n```\n"), (1, 0))
        self.assertEqual(self.programs("<!-- part -->\n```cpp\nh();\n```\n"), (1, 2))
        self.assertEqual(self.programs("```cpp\nf();\n```\n"), (1, 2))

    def test_only_marked_commands_run(self):
        self.assertEqual(self.commands("```sh\nfalse\n```\n\n<!-- run -->\n```sh\ntrue\n```\n"),
                         (1, 0))

    def test_the_status_must_be_the_stated_one(self):
        self.assertEqual(self.commands("<!-- run: 3 -->\n```sh\nexit 3\n```\n"), (1, 0))
        self.assertEqual(self.commands("<!-- run -->\n```sh\nexit 3\n```\n"), (1, 1))
        self.assertEqual(self.commands("<!-- run -->\n```sh\nfalse\ntrue\n```\n"), (1, 1))

    def test_the_output_must_be_the_shown_one(self):
        def readme(shown):
            return f"<!-- run -->\n```sh\necho one; echo two\n```\n<!-- output -->\n```text\n{shown}\n```\n"
        self.assertEqual(self.commands(readme("one\ntwo")), (1, 0))
        self.assertEqual(self.commands(readme("o...\n...wo")), (1, 0))
        self.assertEqual(self.commands(readme("one")), (1, 1))
        self.assertEqual(self.commands(readme("one\nthree")), (1, 1))

    def test_links_lead_to_files_and_headings(self):
        self.document("# A heading, which is long\n", "other.md")
        good = "[a](other.md) [b](other.md#a-heading-which-is-long) [c](https://x.y) [d](#top)\n# Top"
        self.assertEqual(self.links(good), (3, 0))
        self.assertEqual(self.links("[a](none.md)\n"), (1, 1))
        self.assertEqual(self.links("[a](other.md#no-heading)\n"), (1, 1))

    def test_named_sources_exist(self):
        self.assertEqual(self.links("`src/NAME/NAME.cpp` `include/pelt/pelt.hpp` `a/b.c`\n"), (1, 0))
        self.assertEqual(self.links("`src/none.cpp`\n"), (1, 1))

    def test_blocks_share_a_folder_and_see_the_programs(self):
        tool = self.folder / "tool"
        tool.write_text("#!/bin/sh\ntouch made\n")
        tool.chmod(0o755)
        self.assertEqual(self.commands("<!-- run -->\n```sh\ntool\n```\n\ntext\n\n"
                                       "<!-- run -->\n```sh\ntest -e made\n```\n"), (2, 0))


if __name__ == "__main__":
    unittest.main()
