#!/usr/bin/env python3
"""Checks the programs and commands that documents show, and their links.

    check_readme.py programs EXAMPLES_FOLDER DOCUMENT...
    check_readme.py commands DOCUMENT BIN_FOLDER [SECONDS]
    check_readme.py links DOCUMENT...

programs: each ```cpp block must equal one of EXAMPLES_FOLDER/*.cpp, or after a line `<!-- part -->`,
indented by two spaces, be a part of one. Each of these files must be shown by one of the documents.

commands: runs the ```sh blocks that follow a line `<!-- run -->`, in order, in one empty folder,
with BIN_FOLDER first on the PATH; each must end with status 0, or with N after `<!-- run: N -->`.
A ```text block after `<!-- output -->` must equal the output of the last block, including standard
error; `...` matches any text, also across lines.

links: each link to a file or a picture must lead to one, and to one of its headings if it names one.
Each path of a source in backticks, such as `src/skin/skin.hpp`, must exist, unless NAME is a part of it.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = re.compile(r"`((?:asset|bindings|evaluation|include|paper|scenes|scripts|src|tests|tools|viewer)"
                    r"/(?!.*NAME)[\w/.-]+\.\w+)`")
BLOCK = re.compile(r"(?:^<!-- *(?P<mark>[^\n]*?) *-->\n+)?^```(?P<language>\w+)\n(?P<text>.*?)^```$",
                   re.MULTILINE | re.DOTALL)


def blocks(readme, language):
    """Yields (line, mark, text) of each fenced block of a language, or of all blocks for None."""
    text = pathlib.Path(readme).read_text()
    for match in BLOCK.finditer(text):
        if language in (None, match["language"]):
            yield text.count("\n", 0, match.start("text")), match["mark"] or "", match["text"]


def check_programs(folder, *documents):
    examples = {file.name: file.read_text() for file in pathlib.Path(folder).glob("*.cpp")}
    count, wrong, unseen = 0, [], set(examples)
    for document in documents:
        for line, mark, text in blocks(document, "cpp"):
            part = textwrap.indent(text, "  ")
            shown = {name for name, example in examples.items()
                     if text == example or (mark == "part" and part in example)}
            if not shown:
                wrong.append(f"{document}:{line}: this program is none of {folder}/*.cpp")
            count, unseen = count + 1, unseen - shown
    wrong += [f"no document shows {folder}/{name}" for name in sorted(unseen)]
    return count, wrong


def matches(expected, output):
    """Returns whether the output matches the expected text, in which `...` matches anything."""
    pattern = ".*".join(map(re.escape, expected.strip().split("...")))
    return re.fullmatch(pattern, output.strip(), re.DOTALL)


def check_commands(readme, bin_folder, seconds=600):
    ran, wrong, output = 0, [], ""
    with tempfile.TemporaryDirectory() as folder:
        for line, mark, text in blocks(readme, None):
            if run := re.fullmatch(r"run(?:: *(\d+))?", mark):
                print(f"{readme}:{line}:\n{text}", flush=True)
                done = subprocess.run(
                    ["bash", "-euc", f'PATH="{bin_folder}:$PATH"\n{text}'], cwd=folder, text=True,
                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=float(seconds))
                ran, output = ran + 1, done.stdout
                print(output)
                if done.returncode != int(run[1] or 0):
                    wrong.append(f"{readme}:{line}: ended with status {done.returncode}")
            elif mark == "output" and not matches(text, output):
                wrong.append(f"{readme}:{line}: printed something else")
    return ran, wrong


def headings(document):
    """Returns the names by which links call the headings of a document."""
    found = re.findall(r"^#+ (.*)$", document.read_text(), re.MULTILINE)
    return [re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in found]


def check_links(*documents):
    count, wrong = 0, []
    for document in map(pathlib.Path, documents):
        text = document.read_text()
        links = re.findall(r"\]\((?!https?:)([^)#]*)#?([^)]*)\)", text)
        sources = SOURCE.findall(text)
        wrong += [f"{document}: there is no {path}" for path in sources if not (ROOT / path).exists()]
        for path, heading in links:
            target = document.parent / path if path else document
            if not target.exists() or (heading and heading not in headings(target)):
                wrong.append(f"{document}: nothing is at {path}{heading and '#' + heading}")
        count += len(links) + len(sources)
    return count, wrong


CHECKS = {"programs": check_programs, "commands": check_commands, "links": check_links}


def main():
    if len(sys.argv) < 3 or sys.argv[1] not in CHECKS:
        sys.exit(__doc__)
    count, wrong = CHECKS[sys.argv[1]](*sys.argv[2:])
    print(*wrong, f"{count} {sys.argv[1]} checked, {len(wrong)} wrong", sep="\n")
    sys.exit(bool(wrong) or count == 0)


if __name__ == "__main__":
    main()
