# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Parts of a long list, for tests that see all of it in several days (`--part day/3`)."""
import os
import subprocess

TURN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "turn")


def part_of(text):
    """(K, N) of 'K/N', or of 'day/N': then K turns with the date of the last commit."""
    which, number = text.split("/")
    if which == "day":
        which = subprocess.run([TURN, number], capture_output=True, check=True).stdout
    return int(which), int(number)
