# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits of memory and time of programs that tests start."""
import os
import resource


def limit(memory, seconds):
    """Limits this process and the program that it executes: address space (bytes), unless with the address sanitizer,
    which reserves terabytes that it never uses; and processor time (s). Disables core dumps."""
    if "ASAN_OPTIONS" not in os.environ:
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
