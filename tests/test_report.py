#!/usr/bin/python3
"""The page of scripts/report.py: complete, alone in the world, the same for the same input.  Prints TAP."""

import re
import shutil
import sys
import tempfile
import urllib.parse
import xml.etree.ElementTree as tree
from html.parser import HTMLParser
from pathlib import Path

from runner import ROOT, run_tests

sys.path.insert(0, str(ROOT / "scripts"))
import report  # noqa: E402

VOID = {"meta", "br", "img"}
QUICK = ("peers_quick", "peers_quick_short")  # where the quick run keeps its results


class Page(HTMLParser):
    """Open elements must be closed in order; keeps ids, links, rows of the tables by caption, and text."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.links, self.rows, self.caption, self.words = [], [], [], {}, None, []
        self.feed(text)
        self.close()
        assert not self.open, f"left open: {self.open}"

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.ids += [attributes["id"]] if "id" in attributes else []
        self.links += [attributes[name] for name in ("href", "src") if name in attributes]
        if tag == "caption":
            self.caption = attributes["id"]
            self.rows[self.caption] = -1  # the head
        if tag == "tr" and self.caption:
            self.rows[self.caption] += 1
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, f"</{tag}> out of place, line {self.getpos()[0]}"

    def handle_data(self, data):
        self.words.append(data)


def copy_of_results(folder):
    """What the page is made of, small enough to change."""
    for name in ("tables", "figures"):
        shutil.copytree(ROOT / "results" / name, folder / name)
    shutil.copy(ROOT / "results/claims.md", folder)
    (folder / "raw").mkdir()
    return folder


def test_page_of_the_committed_results():
    text = report.make(ROOT / "results")
    page = Page(text)
    claims = report.read_claims(ROOT / "results/claims.md")
    assert len(claims) > 100
    assert [i for i in page.ids if i.startswith("claim-")] == [f"claim-{c['id']}" for c in claims]
    assert len(set(page.ids)) == len(page.ids), "an id twice"
    for link in page.links:
        assert link.startswith("data:") or link[1:] in page.ids, f"leads elsewhere: {link[:60]}"
    assert page.rows["table-claims"] == len(claims)
    for _, _, names, figures in report.CHAPTERS:
        for name in names:
            table = report.read_table(ROOT / f"results/tables/{name}.md")
            if name in QUICK:
                assert table is None, f"{name}: a quick run's among those of the full one"
                continue
            assert page.rows[f"table-{name}"] == len(table["rows"]), name
        for name in figures:
            assert f"figure-{name}" in page.ids, name
    assert len(text) < 2e6, f"{len(text)} characters"
    assert report.make(ROOT / "results") == text, "not the same again"


def test_no_address_but_namespaces():
    text = report.make(ROOT / "results")
    for address in re.findall(r"https?:/*[^'\"\s<]*", text):
        assert address.startswith("http://www.w3.org/"), address


def test_figures_are_svg():
    """What is left of a figure after rounding is still well formed."""
    for _, _, _, figures in report.CHAPTERS:
        for name in figures:
            figure = report.read_figure(name, ROOT / "results/figures")
            root = tree.fromstring(urllib.parse.unquote(figure["data"]))
            assert root.tag == "{http://www.w3.org/2000/svg}svg", name
            assert '"' not in figure["data"] and "#" not in figure["data"], name


def test_a_verdict_that_changes_shows():
    with tempfile.TemporaryDirectory() as name:
        folder = copy_of_results(Path(name))
        path = folder / "claims.md"
        before = report.summary(report.read_claims(path))
        text = path.read_text()
        assert text.count("| holds |") == before["holds"]
        path.write_text(text.replace("| holds |", "| fails |", 1))
        after = report.summary(report.read_claims(path))
        assert after["fails"] == before["fails"] + 1 and after["holds"] == before["holds"] - 1
        words = " ".join(" ".join(Page(report.make(folder)).words).split())
        assert f"{after['fails']} fails" in words


def test_what_is_missing_is_left_out():
    """Peers need not be installed; before the first run there is nothing but claims."""
    with tempfile.TemporaryDirectory() as name:
        folder = copy_of_results(Path(name))
        (folder / "tables/peers.md").unlink()
        page = Page(report.make(folder))
        assert "table-peers" not in page.ids and "table-speed" in page.ids
        shutil.rmtree(folder / "tables")
        shutil.rmtree(folder / "figures")
        assert "table-speed" not in Page(report.make(folder)).ids


def test_text_is_escaped():
    with tempfile.TemporaryDirectory() as name:
        folder = copy_of_results(Path(name))
        path = folder / "tables/speed.md"
        path.write_text(path.read_text().replace("one crossing", "<script>one & crossing</script>"))
        words = Page(report.make(folder)).words
        assert any(w == "<script>one & crossing</script>" for w in words)


def test_a_table_that_is_none():
    with tempfile.TemporaryDirectory() as name:
        folder = copy_of_results(Path(name))
        path = folder / "tables/speed.md"
        path.write_text(path.read_text() + "| one cell |\n")
        try:
            report.make(folder)
        except SystemExit as reason:
            assert "speed.md" in str(reason)
        else:
            raise AssertionError("taken")


if __name__ == "__main__":
    run_tests(globals())
