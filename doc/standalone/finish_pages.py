#!/usr/bin/env python3
"""Usage: finish_pages.py HTML XML

Brings the pages that doxygen has written into the form of CGAL's manual, where no setting does so: concepts, which are classes
to doxygen, are called concepts; figures have numbers; the tree at the side shows the chapters and sections of the user manual, and
short names; and where the window is too narrow for the tree, a line of links takes its place."""

import json
import pathlib
import re
import sys
import xml.etree.ElementTree

NAMESPACE = "CGAL::Spherical_parameterization::"
LINKS = """<div id="narrow-links"><a href="index.html">User Manual</a>
<a href="group__PkgSphericalParameterizationRef.html">Reference Manual</a>
<a href="annotated.html">Class and Concept List</a>
<a href="examples.html">Examples</a></div>
"""


def finish_page(text):
    text = text.replace("</div><!-- top -->", LINKS + "</div><!-- top -->")
    # On the pages of classes, the heading is "Definition"; on those of groups, the title says enough.
    text = text.replace('<h2 class="groupheader">Detailed Description</h2>', "")
    text = text.replace('<div class="title">Class List</div>', '<div class="title">Class and Concept List</div>')
    text = text.replace("Here are the classes, structs, unions and interfaces with brief descriptions:",
                        "Here are the classes and concepts with brief descriptions:")
    if '<div class="concept"></div>' in text:
        text = text.replace(" Class Reference<", " Concept Reference<")
        text = re.sub(r"<p><code>#include &lt;Concepts/.*</code></p>\n", "", text)
    if '<div class="title">Concepts<' in text:
        text = text.replace('</a>\nClasses</h2>', '</a>\nConcepts</h2>').replace(">Classes</a>", ">Concepts</a>")
        text = text.replace(">class &#160;<", ">concept &#160;<")
    return text


def sections(element):
    """The sections of a page as nodes of the tree: name, address, children."""
    level = {"detaileddescription": "sect1", "sect1": "sect2"}.get(element.tag)
    result = []
    for section in element.findall(level) if level else []:
        page, anchor = section.get("id").split("_1", 1)
        result.append(["".join(section.find("title").itertext()), f"{page}.html#{anchor}", sections(section) or None])
    return result


def chapters(xml, page):
    """The sections and subpages of a page as nodes of the tree."""
    root = xml_root(xml / f"{page}.xml").find("compounddef")
    nodes = sections(root.find("detaileddescription"))
    for inner in root.findall("innerpage"):
        identifier = inner.get("refid")
        title = xml_root(xml / f"{identifier}.xml").findtext("compounddef/title")
        nodes.append([title, f"{identifier}.html", chapters(xml, identifier) or None])
    return nodes


def xml_root(file):
    return xml.etree.ElementTree.parse(file).getroot()


def paths(nodes, path):
    for i, (_, address, children) in enumerate(nodes):
        yield address, path + [i]
        yield from paths(children or [], path + [i])


def number_figures(html, pages):
    """Numbers the figures in the order in which they stand in the pages, and says so wherever one is referred to."""
    names = []
    for page in pages:
        names += re.findall(r'id="fig__(\w+)"', (html / page).read_text())
    numbers = {name: i + 1 for i, name in enumerate(dict.fromkeys(names))}
    for page in html.glob("*.html"):
        text = page.read_text()
        numbered = re.sub(r">fig__(\w+)</a>", lambda m: f">Figure {numbers[m.group(1)]}</a>", text)
        if numbered != text:
            page.write_text(numbered)


def finish_tree(html, nodes):
    data = html / "navtreedata.js"
    text = data.read_text()
    assert text.count('[ "User Manual", "index.html", null ]') == 1, "the tree of the pages is not as expected"
    text = text.replace('[ "User Manual", "index.html", null ]', f'[ "User Manual", "index.html", {json.dumps(nodes)} ]')

    # Which file holds the way to an address is found by comparison with the first address in each.
    top = re.findall(r'^    \[ "[^"]*", "([^"]*)"', text, re.MULTILINE)
    firsts = re.findall(r'^"(.*?)",?$', text[text.index("var NAVTREEINDEX"):], re.MULTILINE)
    text = text.replace(f'"{firsts[0]}"', '""', 1)
    firsts[0] = ""
    data.write_text(text)
    files = [html / f"navtreeindex{i}.js" for i in range(len(firsts))]
    ways = {}
    for file in files:
        source = file.read_text()
        ways.update(json.loads(source[source.index("{"):source.rindex("}") + 1]))
    ways.update(paths(nodes, [0]))
    ways.update({address: [i] for i, address in enumerate(top)})
    for page in html.glob("*.html"):  # those that the tree does not show: lists of members, the bibliography and the like
        ways.setdefault(page.name, ways.get(page.name.replace("-members.html", ".html"), []))
    for address in ways:
        assert (html / address.split("#")[0]).is_file(), f"the tree links to {address}, which is not there"
    for i, file in enumerate(files):
        end = firsts[i + 1] if i + 1 < len(firsts) else "~"
        part = {address: way for address, way in sorted(ways.items()) if firsts[i] <= address < end}
        file.write_text(f"var NAVTREEINDEX{i} = {json.dumps(part, indent=0)};\n")

    for file in html.glob("*.js"):
        text = file.read_text()
        if re.match(r"var (group__|annotated|modules)", text):
            file.write_text(re.sub(rf'\[ "{NAMESPACE}(\w+)[^"]*"', r'[ "\1"', text))


def main():
    html, xml = map(pathlib.Path, sys.argv[1:])
    for page in html.glob("*.html"):
        page.write_text(finish_page(page.read_text()))
    nodes = chapters(xml, "indexpage")
    addresses = [address.split("#")[0] for address, _ in paths(nodes, [])]
    number_figures(html, dict.fromkeys(["index.html"] + addresses))
    finish_tree(html, nodes)


main()
