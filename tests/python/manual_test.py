# SPDX-License-Identifier: MIT
"""docs/python.md runs from top to bottom, quotes what the example has and prints, and help() tells what there is."""

import ast
import inspect
import io
import os
import pickle
import pydoc
import re
import subprocess
import sys
import unittest
from contextlib import redirect_stdout

import sspql
from every import CLASSES

SOURCE = os.environ["SSPQL_SOURCE"]


def text(*path):
    with open(os.path.join(SOURCE, *path), encoding="utf-8") as file:
        return file.read()


class Manual(unittest.TestCase):
    def test_every_block_runs(self):
        blocks = re.findall(r"^```python\n(.*?)^```", text("docs", "python.md"), re.MULTILINE | re.DOTALL)
        self.assertGreater(len(blocks), 5)
        names = {"__name__": "manual"}
        with redirect_stdout(io.StringIO()) as printed:
            for block in blocks:
                exec(compile(block, "docs/python.md", "exec"), names)
        self.assertIn("AdaptiveSspql", printed.getvalue())
        cut = names["Cut"]
        env = type("Env", (), {"action_space": None, "reset": lambda self: ((-1.2, 0.07), {})})
        cut = cut(env(), [-1.2, -0.07], [0.6, 0.07], [20, 20])
        self.assertEqual(cut.reset(), (19, {}))

    def test_it_quotes_the_example(self):
        quoted = re.search(r"first_steps.py, checked by a test -->\n```python\n(.*?)^```", text("docs", "python.md"),
                           re.MULTILINE | re.DOTALL)
        example = text("examples", "python", "first_steps.py").splitlines()
        at = 0
        for line in quoted.group(1).splitlines():  # in this order; the example has more imports
            self.assertIn(line, example[at:])
            at = example.index(line, at) + 1
        printed = re.search(r"printed by .*?first_steps.py, checked by a test -->\n```text\n(.*?)^```",
                            text("docs", "python.md"), re.MULTILINE | re.DOTALL)
        path = os.path.join(SOURCE, "examples", "python", "first_steps.py")
        done = subprocess.run([sys.executable, path], capture_output=True, text=True, check=True)
        self.assertEqual(printed.group(1), done.stdout)

    def test_it_names_every_class_parameter_and_member(self):
        manual = text("docs", "python.md")
        for cls in CLASSES:
            self.assertIn(f"`{cls.__name__}`", manual)
            for preset in sspql._core.presets(cls._kind):
                self.assertIn(f"`{preset}`", manual)
                self.assertEqual(type(cls(3, 2, preset=preset)), cls)
        members = {name for cls in CLASSES for name in dir(cls) if not name.startswith("_")}
        for name in members - {"running", "state", "action", "states", "actions", "copy", "update_paths", "status"}:
            self.assertRegex(manual, rf"\b{name}\b")


class Help(unittest.TestCase):
    def test_signatures_are_those_of_the_library(self):
        for cls in CLASSES:
            signature = inspect.signature(cls)
            self.assertEqual(list(signature.parameters)[:4], ["states", "actions", "seed", "preset"])
            defaults = {name: p.default for name, p in list(signature.parameters.items())[4:]}
            self.assertEqual(cls(3, 2).parameters, defaults)

    def test_help_lists_the_parameters(self):
        for cls in CLASSES:
            shown = pydoc.plain(pydoc.render_doc(cls))
            for name, default, what in sspql._core.parameters(cls._kind):
                self.assertIn(f"{name} = {default!r}", shown)
                self.assertIn(what.split()[0], shown)
            for member in ("begin", "step", "end", "observe", "explain", "set_goals", "save"):
                self.assertRegex(shown, rf"{member}\(self: sspql.Learner")
            self.assertLessEqual(max(map(len, cls.__doc__.splitlines())), 120)

    def test_everything_public_has_a_docstring(self):
        for name in sspql.__all__:
            thing = getattr(sspql, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if not inspect.isclass(thing):
                continue
            for member in dir(thing):
                if not member.startswith("_") and not hasattr(tuple, member) and thing is not sspql.EpisodeResult:
                    documented = inspect.getdoc(getattr(thing, member)) or member in ("p", "start", "rate", "floor")
                    self.assertTrue(documented, f"{name}.{member}")

    def test_stubs_name_what_there_is(self):
        tree = ast.parse(text("python", "sspql", "_core.pyi"))
        for node in tree.body:
            if not isinstance(node, ast.ClassDef):
                continue
            compiled = getattr(sspql._core, node.name)
            there = {name for name in dir(compiled) if not name.startswith("_")}
            stubs = {f.name: f for f in node.body if not f.name.startswith("_")}
            self.assertEqual(set(stubs), there, node.name)
            for name in there:
                if node.name == "Learner" and not stubs[name].decorator_list:  # the arguments, too
                    shown = re.match(r"\w+\((.*?)\) ->", getattr(compiled, name).__doc__).group(1)
                    arguments = re.findall(r"(\w+): ", shown)
                    self.assertEqual([argument.arg for argument in stubs[name].args.args], arguments, name)

    def test_without_docstrings(self):
        code = "import sspql; print(sspql.Sspql(3, 2, gamma=0.5).parameters['gamma'])"
        done = subprocess.run([sys.executable, "-OO", "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "0.5\n")

    def test_the_version(self):
        version = text("include", "sspql", "core", "version.hpp")
        self.assertEqual(sspql.__version__, ".".join(re.findall(r"VERSION_(?:MAJOR|MINOR|PATCH) +(\d+)", version)))


class Explanations(unittest.TestCase):
    def test_why(self):
        # Six cells in a row; action 1 leads on, and was carried out.
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                learner = cls(6, 2, seed=1)
                for _ in range(40):
                    for s in range(5):
                        learner.observe(s, 1, float(s == 4), s + 1, s == 4)
                        learner.observe(s, 0, 0.0, max(s - 1, 0), False)
                why = learner.explain(2, actions=["back", "on"])
                self.assertEqual((why.state, why.best, why.chosen), (2, 1, None))
                self.assertIn("best as far as known: on", str(why))
                self.assertEqual(repr(why), str(why))
                if hasattr(cls, "counts"):
                    self.assertEqual(why.next, 3)
                    self.assertEqual(why.path, [(2, 1), (3, 1), (4, 1), (5, None)])
                    self.assertEqual(why.distance, learner.shortest_paths()[0][2])
                    self.assertEqual(learner.explain(2, most_states=2).path, [(2, 1), (5, None)])
                    self.assertIn("cell 3", str(learner.explain(2, states=lambda s: f"cell {s}")))
                else:
                    self.assertEqual((why.next, why.path), (None, []))
                action = learner.begin(2)
                self.assertEqual(learner.explain(2).chosen, action)
                self.assertEqual(learner.explain(3).chosen, None)

    def test_refusals(self):
        learner = sspql.QLearning(3, 2)
        with self.assertRaisesRegex(ValueError, "state must be below"):
            learner.explain(3)
        with self.assertRaises(IndexError):
            learner.explain(1, actions=["only one"])
        with self.assertRaisesRegex(ZeroDivisionError, "division"):
            learner.explain(1, actions=lambda a: 1 / a)
        with self.assertRaises(TypeError):
            learner.explain(1, actions=3)
        with self.assertRaises(TypeError):
            pickle.dumps(learner.explain(1))


if __name__ == "__main__":
    unittest.main()
