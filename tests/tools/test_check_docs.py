# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Sentences and links, as tools/check_docs.py sees them."""
import unittest

from small_tree import TreeTest, said

import check_docs

GOOD = """# The page

A sentence of six words here. See [the other](docs/other.md#a-place-of-it) and [above](#the-page).

```
[no link](nowhere.md)
```
"""
OTHER = "## A `place` of it\n\nShort.\n"


def sentence(words):
    return "Word " + "word " * (words - 2) + "word."


class CheckDocs(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("README.md", GOOD)
        self.write("docs/other.md", OTHER)

    def faults(self):
        status, text = said(check_docs, self.root)
        faults = [] if text.startswith("docs: ") else text.splitlines()
        self.assertEqual(status, 1 if faults else 0, text)
        return faults

    def test_good_pages(self):
        self.assertEqual(self.faults(), [])

    def test_link_to_no_file(self):
        self.write("docs/other.md", OTHER + "[gone](gone.md)\n")
        self.assertEqual(self.faults(), ["docs/other.md: the link to gone.md leads nowhere"])

    def test_link_to_no_heading(self):
        self.write("docs/other.md", OTHER.replace("place", "room"))
        self.assertEqual(self.faults(), ["README.md: docs/other.md#a-place-of-it names no heading"])

    def test_links_of_decisions_are_followed_but_their_sentences_are_not_measured(self):
        self.write("docs/decisions/0001-a.md", sentence(50) + " [gone](../gone.md)\n")
        self.assertEqual(self.faults(), ["docs/decisions/0001-a.md: the link to ../gone.md leads nowhere"])

    def test_longest_sentence(self):
        for words, count in ((check_docs.LONGEST, 0), (check_docs.LONGEST + 1, 1)):
            self.write("docs/other.md", OTHER + sentence(words) + "\n")
            self.assertEqual(len(self.faults()), count)

    def test_longest_sentence_in_a_cell_that_the_mean_leaves_out(self):
        self.write("docs/other.md", OTHER + f"| a | {sentence(check_docs.LONGEST + 1)} |\n")
        self.assertRegex("".join(self.faults()), "^docs/other.md: a sentence of 41 words, more than 40")

    def test_mean(self):
        for words, faults in ((check_docs.MEAN, []), (check_docs.MEAN + 1, ["docs/other.md: 26.0 words a sentence in the mean, more than 25"])):
            self.write("docs/other.md", "## A place of it\n" + f"{sentence(words)} {sentence(words)}\n")
            self.assertEqual(self.faults(), faults)

    def test_what_ends_a_sentence(self):
        ends = "One, e.g. two [three](x.md). Is it `f(x). G`? Yes! The 1.5 mm of it\n\n* an item\n"
        self.assertEqual([len(words) for _, block in check_docs.blocks(ends) for words in check_docs.sentences(block)], [4, 3, 1, 5, 2])


if __name__ == "__main__":
    unittest.main()
