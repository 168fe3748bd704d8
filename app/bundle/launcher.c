// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the programs of a bundle. As BUNDLE/bin/NAME it runs BUNDLE/libexec/NAME.program with the libraries
// in BUNDLE/lib, by the loader that belongs to them: BUNDLE/libexec/NAME, which has the program's name
// because that is what the system shows of a process. Linked statically, it needs Linux 3.2 or later and
// /proc, and nothing else. The paths are arguments of the loader and no variables, so that the program's
// children are run by the system's own.
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int fail(const char* what, const char* where) {
    fprintf(stderr, "sherd: error: %s: %s\n", where, what);
    return 1;
}

// Cuts bin/NAME off the path of this file. Returns NAME; null when the path is not known.
static char* split_path(char* folder, size_t size) {
    const ssize_t length = readlink("/proc/self/exe", folder, size - 1);
    if (length <= 0) return NULL;
    folder[length] = '\0';
    char* name = strrchr(folder, '/');
    *name = '\0';
    char* bin = strrchr(folder, '/');
    if (bin != NULL) *bin = '\0';
    return name + 1;
}

// Replaces this process; returns only when that is not possible. options: of the program, before what the
// user gave.
static int start(const char* folder, const char* name, const char* const* options, char** given, int count) {
    static char loader[PATH_MAX], program[PATH_MAX], libraries[PATH_MAX], called[PATH_MAX];
    snprintf(loader, sizeof loader, "%s/libexec/%s", folder, name);
    snprintf(program, sizeof program, "%s/libexec/%s.program", folder, name);
    snprintf(libraries, sizeof libraries, "%s/lib", folder);
    snprintf(called, sizeof called, "%s/bin/%s", folder, name);
    const char** arguments = calloc((size_t)count + 16, sizeof *arguments);
    if (arguments == NULL) return fail(strerror(errno), loader);
    int n = 0;
    arguments[n++] = loader;
    arguments[n++] = "--inhibit-cache";
    arguments[n++] = "--library-path";
    arguments[n++] = libraries;
    arguments[n++] = "--argv0";
    arguments[n++] = called;
    arguments[n++] = program;
    while (*options != NULL) arguments[n++] = *options++;
    memcpy(arguments + n, given, (size_t)count * sizeof *given);
    execv(loader, (char**)arguments);
    return fail(errno == ENOENT ? "is not in this bundle" : strerror(errno), loader);
}

int main(int argc, char** argv) {
    static const char* const none[] = {NULL};
    // Modules that are meant for the system's Python are left out: they want its libraries.
    static const char* const of_python[] = {"-E", "-s", NULL};
    static char folder[PATH_MAX - 64];
    const char* name = split_path(folder, sizeof folder);
    if (name == NULL) return fail("cannot be read; is /proc mounted?", "/proc/self/exe");
    if (strpbrk(folder, ":;$") != NULL)
        return fail(
            "the loader of programs does not take ':', ';' and '$' in a folder's name; move the bundle",
            folder);
    unsetenv("LD_PRELOAD");  // libraries of the system do not fit the bundle's C library
    unsetenv("LD_AUDIT");
    int first = argc > 0 ? 1 : 0;
    if (strcmp(name, "sherd") == 0 && argc > 1 && strcmp(argv[1], "python") == 0) {
        name = "sherd-python";
        ++first;
    }
    const int is_python = strcmp(name, "sherd-python") == 0;
    return start(folder, name, is_python ? of_python : none, argv + first, argc - first);
}
