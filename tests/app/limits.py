# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program that a test starts may take."""
import os
import resource


def limit(memory, seconds):
    """For this process, and what it becomes: address space in bytes and processor time, with the address sanitizer
    twenty times that and all address space, since it reserves terabytes that it never uses. It leaves no core."""
    if "ASAN_OPTIONS" in os.environ:
        seconds *= 20
    else:
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
