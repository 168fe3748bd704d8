# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds commands of pages against the programs, the project's scripts, and the presets, targets and tests of the
build."""
import collections
import functools
import json
import pathlib
import re
import shlex
import shutil

from docs_test import TOP, text_of
from scene_snippets import errors_of, output_of

OTHERS = ("alias", "apt", "awk", "ffmpeg", "man", "printf", "sudo", "time")  # the system's, which are not checked
# Options of ctest and the number of their values.
CTEST = {"-R": 1, "-E": 1, "-L": 1, "-LE": 1, "-V": 0, "--parallel": 1, "--preset": 1, "--test-dir": 1}
Option = collections.namedtuple("Option", "name value choices least most")  # least, most: the number of its values
Help = collections.namedtuple("Help", "commands options places")


def option_of(words):
    """Returns the Option that a help lists as these words, which stand before the description."""
    name, _, value = re.sub(r" *\b(Needs|Excludes|REQUIRED)\b.*", "", words).partition(" ")
    listed = re.fullmatch(r"[A-Z:]*\{(.*)\}|([a-z0-9]+(\|[a-z0-9]+)+)", value)
    choices = re.split(r"[,|]", listed[1] or listed[2]) if listed else None
    least = 0 if not value or value.startswith("[") else 1
    return Option(name, value, choices, least, 99 if value.endswith("...") else 1 if value else 0)


@functools.cache
def help_of(program, command=()):
    """Returns the Help of a program, or of one of its commands."""
    found, part = Help(set(), {}, []), None
    for line in output_of(program, *command, "--help").splitlines():
        words = re.split(r"\s{2,}", line.strip())[0]
        if line.endswith(":") and not line.startswith(" "):
            part = line
        elif part == "Subcommands:" and re.match(r"  \w", line):
            found.commands.add(words)
        elif part == "Positionals:" and re.match(r"  \w", line):
            found.places.append(option_of(words))
        elif part == "Options:" and re.match(r"  -", line):
            found.options.update((name, option_of(words)) for name in words.split()[0].split(","))
    return found


def is_open(word):
    """Returns whether a word stands for others: it has capitals, dots or brackets."""
    return bool(re.search(r"\b[A-Z]{2,}\b|\.\.\.|^\[|[{}]", word))


def bare(word):
    """Returns a word without brackets that hold more than the word, or an option: [-o FILE] has -o and FILE."""
    word = word.removeprefix("[") if word.startswith("[-") else word
    return word.removesuffix("]") if word.count("]") > word.count("[") else word


def taken(words, options):
    """Returns what words of a command line are: (option, its values) of each option, all other words, and a list of
    faults."""
    words, found, others, faults = [bare(word) for word in words], [], [], []
    while words:
        word = words.pop(0)
        name, equals, value = word.partition("=") if word.startswith("--") else (word, "", "")
        if not re.match(r"--?[a-z]", name):
            others.append(word)
        elif name not in options:
            faults.append(f"has no option {name}")
        else:
            option, values = options[name], [value] if equals else []
            while words and (len(values) < option.least or len(values) < option.most and words[0][0] != "-"):
                values.append(words.pop(0))
            if len(values) < option.least:
                faults.append(f"{name} needs a value")
            found.append((option, values))
    return found, others, faults


def simple_commands(line):
    """Returns the commands of a line of the shell, each a list of words, without redirections and assignments."""
    lexer = shlex.shlex(line, posix=True, punctuation_chars=True)
    lexer.whitespace_split = True
    commands, words = [[]], list(lexer)
    while words:
        word = words.pop(0)
        if re.fullmatch(r"[|&;()]+", word):
            commands.append([])
        elif re.fullmatch(r"[<>]+", word):
            words = words[1:]
        elif word != "time" and (commands[-1] or not re.match(r"\w+=", word)):
            commands[-1].append(word)
    return [command for command in commands if command]


def presets(kind):
    return {preset["name"] for preset in json.loads(text_of(TOP / "CMakePresets.json"))[kind]}


def faults_of_folder(folder):
    """Returns a list of faults: empty if a preset builds in this folder."""
    known = {f"build/{preset}" for preset in presets("configurePresets")}
    return [] if folder in known or is_open(folder) else [f"{folder} is the folder of no preset"]


class CommandSnippets:
    """Commands of the programs `sherd` and `sherd-bench` (bench), of scripts, and of CMake in a build folder. Faults are
    texts."""

    def __init__(self, sherd, bench, build, scenes, faults_of_python):
        self.programs = {"sherd": sherd, "sherd-bench": bench}
        self.build, self.scenes, self.faults_of_python = build, scenes, faults_of_python

    def faults(self, line, is_mention=False):
        """Returns what is wrong with a line of the shell. A mention may leave out what a command needs."""
        try:
            commands = simple_commands(line)
        except ValueError as error:
            return [f"{error}: {line}"]
        return [fault for name, *words in commands for fault in self.faults_of_command(name, words, is_mention)]

    def faults_of_command(self, name, words, is_mention):
        program = name.split("/")[-1]
        if program in self.programs:
            return self.faults_of_program(program, words, is_mention)
        if name == "cmake":
            return self.faults_of_cmake(words)
        if name == "ctest":
            return self.faults_of_ctest(words)
        if name == "python3":
            return self.faults_of_python(words[1]) if words[:1] == ["-c"] else []
        if "/" in name:
            return self.faults_of_script(name, words)
        return [] if name in OTHERS else [f"{name} is no program that is known here"]

    def faults_of_program(self, name, words, is_mention):
        program, command = self.programs[name], ()
        if words and help_of(program).commands and not words[0].startswith("-"):
            if is_open(words[0]) or words[0] == "python":  # a bundle has this command
                return []
            if words[0] not in help_of(program).commands:
                return [f"{name} has no command {words[0]}"]
            command, words = (words[0],), words[1:]
        name = " ".join((name, *command))
        _, options, places = help_of(program, command)
        found, others, faults = taken(words, options)
        for option, value in [*((option, value) for option, values in found for value in values), *zip(places, others)]:
            faults += self.faults_of_value(option, value)
        is_short = len(others) < len(places) and not {"--help", "--version"} & set(words)
        if len(others) > len(places) or is_short:
            faults.append(f"takes {len(places)} words, not {len(others)}")
        return [f"{name} {fault}" for fault in faults
                if not is_mention or not (fault.endswith("needs a value") or is_short and fault.startswith("takes"))]

    def faults_of_value(self, option, value):
        if option.name == "--set":
            return [] if is_open(value.partition("=")[0]) else self.scenes.faults_of_setting(value)
        if is_open(value):
            return []
        if option.choices and value not in option.choices:
            return [f"{option.name} {value}: is none of {', '.join(option.choices)}"]
        if option.name == "--keys":
            return errors_of([self.programs["sherd"], "scenes", "--keys", value], TOP)
        if option.value not in ("SCENE", "SCENE.toml", "STUDY.toml"):
            return []
        # A file that is none of the project's may have any name.
        if value.endswith(".toml") and "/" in value and not (TOP / value).is_file():
            return [f"{value}: is not there"]
        is_name = not value.endswith(".toml") and not value.startswith("/")
        return [f"{value}: no scene of this name comes with it"] if is_name and value not in self.scenes.shipped else []

    @functools.cached_property
    def tests(self):
        """The names of all tests, and the labels."""
        listed = json.loads(output_of("ctest", "--test-dir", self.build, "--show-only=json-v1"))["tests"]
        labels = [entry["value"] for test in listed for entry in test.get("properties", []) if entry["name"] == "LABELS"]
        return {test["name"] for test in listed}, set().union(*labels)

    def faults_of_ctest(self, words):
        """Returns options of ctest that are not in CTEST, and those that choose no test."""
        words, faults = list(words), []
        while words:
            name = words.pop(0)
            if name not in CTEST:
                faults.append(f"ctest: {name} is no option that is known here")
            value = words.pop(0) if words and CTEST.get(name) else ""
            among = {"-R": self.tests[0], "-E": self.tests[0], "-L": self.tests[1], "-LE": self.tests[1]}.get(name, ())
            if among and not any(re.search(value, test) for test in among):
                faults.append(f"{name} {value} chooses no test")
            if name == "--preset" and value not in presets("testPresets"):
                faults.append(f"--preset {value} is none of the tests")
            if name == "--test-dir":
                faults += faults_of_folder(value)
        return faults

    @functools.cached_property
    def targets(self):
        listed = output_of("ninja", "-C", self.build, "-t", "targets", "all")
        return {pathlib.PurePath(line.split(": ")[0]).name for line in listed.splitlines()}

    def faults_of_cmake(self, words):
        """Returns presets, targets, folders and settings of the build that are not there."""
        faults = []
        for word, after in zip(words, [*words[1:], "..."]):
            if word == "--preset" and after not in presets("configurePresets"):
                faults.append(f"--preset {after} is none of the build")
            if word in ("--build", "--install"):
                faults += faults_of_folder(after)
            setting = re.match(r"-D(\w+)", word)
            if setting and not re.search(rf"\b{setting[1]}\b", text_of(self.build / "CMakeCache.txt")
                                         + text_of(self.build / "CPackConfig.cmake")):
                faults.append(f"-D{setting[1]} is no setting of the build")
        if "--target" in words:
            named = words[words.index("--target") + 1:]
            faults += [f"--target {name} is none of the build" for name in named
                       if not name.startswith("-") and name not in self.targets]
        return faults

    def faults_of_script(self, name, words):
        """Returns why a script or a program of the build cannot be called so; options have to stand in the script."""
        file = self.build / pathlib.PurePath(name).relative_to("build/release") if name.startswith("build/release/") \
            else TOP / name
        if not file.is_file() or not shutil.which(file):
            return [f"{name} is {'no program' if file.is_file() else 'not there'}"]
        if name in ("tests/run", "tests/long"):
            return self.faults_of_ctest([word for word in words if word != "--short" or name == "tests/run"])
        return [f"{name} has no option {word}" for word in words
                if re.match(r"--?[a-z]", word) and not re.search(rf"(?<![\w-]){word}(?![\w-])", text_of(file))]
