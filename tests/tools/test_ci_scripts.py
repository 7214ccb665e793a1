# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What .ci/run leans on: tools/turn, tools/check_subjects, tools/same_cases.py, tools/same_bytes.py, tools/part_of_day.py,
tools/run_cases.py."""
import json
import os
import shutil
import subprocess
import unittest

from small_tree import TreeTest, said

import part_of_day
import run_cases
import same_bytes
import same_cases

TOOLS = os.path.join(run_cases.ROOT, "tools")
DAY = 86400


class Repository(TreeTest):
    """A repository with a script of ours in tools/."""

    def setUp(self):
        super().setUp()
        self.git("init", "-q")

    def git(self, *arguments, day=0):
        date = f"@{(1000 + day) * DAY} +0000"
        names = {f"GIT_{who}_{key}": "a" for who in ("AUTHOR", "COMMITTER") for key in ("NAME", "EMAIL")}
        env = {**os.environ, **names, "GIT_AUTHOR_DATE": date, "GIT_COMMITTER_DATE": date}
        return subprocess.run(["git", "-C", self.root, *arguments], env=env, check=True, capture_output=True, text=True).stdout

    def commit(self, subject, day=0):
        self.git("commit", "-q", "--allow-empty", "-m", subject, day=day)
        return self.git("rev-parse", "HEAD").strip()

    def run_tool(self, name, *arguments, change=lambda text: text):
        with open(os.path.join(TOOLS, name), encoding="utf-8") as file:
            self.write(f"tools/{name}", change(file.read()))
        done = subprocess.run(["bash", os.path.join(self.root, "tools", name), *arguments], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


class Turn(Repository):
    def test_three_days_see_all_three(self):
        parts = []
        for day in range(4):
            self.commit("a day", day)
            status, text = self.run_tool("turn", "3")
            self.assertEqual(status, 0)
            parts.append(int(text))
        self.assertEqual(sorted(parts[:3]), [1, 2, 3])
        self.assertEqual(parts[0], parts[3])


class Subjects(Repository):
    def check(self, begin):
        known = subprocess.run(["grep", "-oE", "^begin=[0-9a-f]+", os.path.join(TOOLS, "check_subjects")],
                               capture_output=True, text=True, check=True).stdout.strip()
        return self.run_tool("check_subjects", change=lambda text: text.replace(known, f"begin={begin}"))

    def test_long_subjects_before_the_beginning_are_forgiven(self):
        begin = self.commit("x" * 90)
        self.commit("é" * 71)
        self.assertEqual(self.check(begin), (0, ""))

    def test_a_subject_of_72_characters_is_too_long(self):
        begin = self.commit("begin")
        self.commit("x" * 72)
        status, text = self.check(begin)
        self.assertEqual(status, 1)
        self.assertIn("too long", text)

    def test_without_the_beginning_a_whole_history_fails_and_a_shallow_one_passes(self):
        begin = self.commit("begin")
        self.commit("x" * 72)
        self.assertEqual(self.check("0" * 40)[0], 1)
        whole, self.root = self.root, os.path.join(self.root, "shallow")
        subprocess.run(["git", "clone", "-q", "--depth", "1", "file://" + whole, self.root], check=True)
        self.assertEqual(self.check(begin)[0], 0)
        shutil.rmtree(self.root)
        self.root = whole


class SameCases(TreeTest):
    def outcome(self, given):
        name = sorted(n for n in os.listdir(run_cases.CASES) if n.endswith(".case.json"))[0]
        with open(os.path.join(run_cases.CASES, name), encoding="utf-8") as file:
            case = json.load(file)
        self.write(name, given(case))
        return said(same_cases, self.root)[0]

    def test_layout_does_not_matter(self):
        self.assertEqual(self.outcome(lambda case: json.dumps(case, indent=7, sort_keys=True)), 0)

    def test_contents_matter(self):
        self.assertEqual(self.outcome(lambda case: json.dumps({**case, "about": "another"})), 1)
        self.assertEqual(self.outcome(lambda case: json.dumps({**case, "id": True})), 1)

    def test_a_case_that_is_missing_and_no_case_at_all(self):
        self.assertEqual(said(same_cases, self.root)[0], 2)
        self.write("Z99.case.json", "{}")
        self.assertEqual(said(same_cases, self.root)[0], 1)

    def test_numbers_are_compared_by_value(self):
        self.assertEqual(same_cases.number("50.0"), same_cases.number("50"))
        self.assertNotEqual(same_cases.number("1"), True)
        self.assertNotEqual(same_cases.number("0.1"), same_cases.number("0.1000000000000000055"))


class Programs(TreeTest):
    """Tests that run a program, here one of the shell's that answers what a test wants."""

    def program(self, script):
        path = self.write("program", "#!/bin/sh\n" + script)
        os.chmod(path, 0o755)
        return path

    def test_bytes_that_change_with_the_threads_are_found(self):
        def outcome(script):
            return said(same_bytes, self.program(script), "--part", "1/50")

        self.assertEqual(outcome("echo same")[0], 0)
        self.assertIn("one thread and two write different bytes", outcome('for last; do :; done; echo "$last"')[1])
        self.assertEqual(outcome('for last; do :; done; exit "$last"')[0], 1)

    def test_bytes_that_change_with_the_order_of_shapes_are_found(self):
        status, text = said(same_bytes, self.program('case "$2" in *-back.json) echo back;; *) echo forth;; esac'), "--part", "1/50")
        self.assertEqual(status, 1)
        self.assertIn("the order of the shapes changes the bytes", text)
        self.assertNotIn("one thread", text)

    def test_nothing_compared_is_no_success(self):
        self.assertEqual(said(same_bytes, self.program("echo same"), "--part", "100000/100000")[0], 1)

    def test_a_part_is_named_or_todays(self):
        self.assertEqual(part_of_day.part_of("2/3"), (2, 3))
        first, step = part_of_day.part_of("day/3")
        self.assertTrue(1 <= first <= step == 3)

    def test_a_case_fails_by_a_wrong_answer_a_crash_a_race_or_a_key_that_nothing_reads(self):
        def outcome(script, **expect):
            case = {"id": "x", "scene": {}, "run": ["map"], "expect": expect}
            return said(run_cases, self.program(script), self.write("x.case.json", json.dumps(case)))[0]

        answer = "echo '{\"attained\": true}'; "
        self.assertEqual(outcome(answer, attained=True), 0)
        self.assertEqual(outcome(answer, attained=False), 1)
        self.assertEqual(outcome(answer + "kill -SEGV $$", attained=True), 1)
        self.assertEqual(outcome(answer + "exit 66", attained=True), 1)  # what ThreadSanitizer makes of a race
        self.assertEqual(outcome(answer, attained=True, atained=True), 1)
        self.assertEqual(outcome(answer), 1)


if __name__ == "__main__":
    unittest.main()
