# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program that a test starts may take."""
import os
import resource


def limit(memory, seconds):
    """For this process, and what it becomes: address space in bytes, unless it has the address sanitizer, which reserves
    terabytes that it never uses; and processor time. It leaves no core."""
    if "ASAN_OPTIONS" not in os.environ:
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
