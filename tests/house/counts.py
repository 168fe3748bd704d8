#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""counts.py [TREE] [--most N] [--pronouns]: counts the C++ sources of a tree of the project, as tables in Markdown.

A source is a .h or .cpp file. Code lines have code, comment lines have a comment and no code; the share of comments is
that of comment lines among both. A comment is a line comment, with those in the same column of the lines below it. It
begins with a pronoun clause if its first words are of, what, whether what, those, these, the same, it, one, that or
which.
--most N: lists the folders with more than N sources (30). --pronouns: lists comments that begin with such a clause.
"""
import argparse
import collections
import math
import pathlib
import re

TOP = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("app", "core", "fracture", "meshops", "tests")
PRONOUNS = re.compile(r"(?:of|whats?|whether what|those|these|the same|its?|one|that|which)\b", re.IGNORECASE)
# Comments, strings and characters of C++, in this order of precedence where they begin; a ' may separate digits.
TOKENS = re.compile(r'(?P<comment>//[^\n]*|/\*.*?\*/)|R"(?P<end>[^(\s]*)\(.*?\)(?P=end)"|"(?:\\.|[^"\\\n])*"'
                    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'", re.DOTALL)


class Counts:
    """Numbers of some sources, which add up."""

    def __init__(self):
        self.lengths, self.code, self.comments, self.blocks, self.pronouns = [], 0, 0, 0, []

    def add(self, other):
        self.lengths += other.lengths
        self.code += other.code
        self.comments += other.comments
        self.blocks += other.blocks
        self.pronouns += other.pronouns

    def row(self, name):
        """Returns a row of the table."""
        share = 100 * self.comments / max(1, self.comments + self.code)
        return (f"| {name} | {len(self.lengths)} | {sum(self.lengths)} | {self.code} | {quantile(self.lengths, 0.5)} | "
                f"{quantile(self.lengths, 0.9)} | {max(self.lengths, default=0)} | {share:.1f} % | {self.blocks} | "
                f"{len(self.pronouns)} |")


def quantile(values, share):
    """Returns the smallest value that at least this share of the values do not exceed; 0 if there are none."""
    return sorted(values)[max(0, math.ceil(share * len(values)) - 1)] if values else 0


def split(text):
    """Returns, for each line of a source, whether it has code, its line comment ("" if none), and its column."""
    comments = collections.defaultdict(lambda: ("", -1))

    def blank(match):
        if match["comment"] is None:
            return re.sub(r"[^\n]", "s", match[0])
        begin = text.rfind("\n", 0, match.start()) + 1
        comments[text.count("\n", 0, match.start())] = (match[0], match.start() - begin)
        return re.sub(r"[^\n]", " ", match[0])

    code = TOKENS.sub(blank, text).split("\n")
    return [(bool(line.strip()), *comments[number]) for number, line in enumerate(code)]


def begins_with_pronoun(comment):
    return PRONOUNS.match(re.sub(r"^(?:/\*+|//[/!]?<?)\s*", "", comment)) is not None


def counted(path, name):
    """Returns the numbers of a source; name is what it is called in lists."""
    found, before = Counts(), -1
    text = path.read_text(encoding="utf-8")
    found.lengths.append(len(text.splitlines()))
    for number, (has_code, comment, column) in enumerate(split(text), 1):
        found.code += has_code
        found.comments += bool(comment) and not has_code
        if "SPDX-License-Identifier" in comment:
            continue
        if comment and (has_code or column != before):
            found.blocks += 1
            if begins_with_pronoun(comment):
                found.pronouns.append(f"{name}:{number}: {comment}")
        before = column
    return found


def counts_by_folder(top):
    """Returns {folder that has sources: its Counts}, without those of its subfolders."""
    found = collections.defaultdict(Counts)
    for folder in FOLDERS:
        for path in sorted((top / folder).rglob("*")):
            if path.suffix in (".h", ".cpp") and path.is_file():
                name = path.relative_to(top)
                found[name.parent.as_posix()].add(counted(path, name.as_posix()))
    return found


def table(by_folder):
    """Returns the lines of the table: a row for each top folder, and one for all but the tests."""
    lines = ["| folder | sources | lines | code | median | 90th percentile | longest | share of comments | comments | "
             "with a pronoun clause |", "| --- " * 10 + "|"]
    library = Counts()
    for folder in FOLDERS:
        total = Counts()
        for name, counts in by_folder.items():
            if name == folder or name.startswith(folder + "/"):
                total.add(counts)
        if folder == "tests":
            lines.append(library.row("all but tests"))
        else:
            library.add(total)
        lines.append(total.row(folder))
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tree", nargs="?", type=pathlib.Path, default=TOP)
    parser.add_argument("--most", type=int, default=30)
    parser.add_argument("--pronouns", action="store_true")
    options = parser.parse_args()
    by_folder = counts_by_folder(options.tree)
    print("\n".join(table(by_folder)))
    sizes = sorted(((len(counts.lengths), name) for name, counts in by_folder.items()), reverse=True)
    print(f"\n{len(sizes)} folders with sources; the largest has {sizes[0][0]}, the median "
          f"{quantile([size for size, _ in sizes], 0.5)}.")
    for size, name in sizes:
        if size > options.most:
            print(f"- {name}/: {size} sources")
    if options.pronouns:
        print("\n" + "\n".join(line for counts in by_folder.values() for line in counts.pronouns))


if __name__ == "__main__":
    main()
