#!/usr/bin/env python3
"""Checks the programs and commands that README.md shows.

    check_readme.py programs README EXAMPLES_FOLDER
    check_readme.py commands README BIN_FOLDER [SECONDS]

programs: each ```cpp block must equal one of docs/examples/*.cpp, and each of these must be shown.

commands: runs the ```sh blocks that follow a line `<!-- run -->`, in order, in one empty folder,
with BIN_FOLDER first on the PATH; each must end with status 0, or with N after `<!-- run: N -->`.
A ```text block after `<!-- output -->` must equal the output of the last block, including standard
error; `...` matches any text, also across lines.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?:^<!-- *(?P<mark>[^\n]*?) *-->\n+)?^```(?P<language>\w+)\n(?P<text>.*?)^```$",
                   re.MULTILINE | re.DOTALL)


def blocks(readme, language):
    """Yields (line, mark, text) of each fenced block of a language, or of all blocks for None."""
    text = pathlib.Path(readme).read_text()
    for match in BLOCK.finditer(text):
        if language in (None, match["language"]):
            yield text.count("\n", 0, match.start("text")), match["mark"] or "", match["text"]


def check_programs(readme, folder):
    examples = {file.read_text(): file.name for file in pathlib.Path(folder).glob("*.cpp")}
    shown = list(blocks(readme, "cpp"))
    wrong = [f"{readme}:{line}: this program is none of {folder}/*.cpp"
             for line, _, text in shown if text not in examples]
    missing = examples.keys() - {text for _, _, text in shown}
    wrong += [f"{readme}: does not show {folder}/{examples[text]}" for text in missing]
    return len(shown), wrong


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


def main():
    if len(sys.argv) < 4 or sys.argv[1] not in ("programs", "commands"):
        sys.exit(__doc__)
    check = check_programs if sys.argv[1] == "programs" else check_commands
    count, wrong = check(*sys.argv[2:])
    print(*wrong, f"{count} blocks checked, {len(wrong)} wrong", sep="\n")
    sys.exit(bool(wrong) or count == 0)


if __name__ == "__main__":
    main()
