#!/usr/bin/env python3
"""Usage: check_documentation.py XML

Checks that the reference manual says of everything in the public headers what a reader of CGAL's manuals expects. XML is what
doxygen writes with EXTRACT_ALL, the undocumented included. Doxygen itself warns of wrong syntax; this is about
what is missing. Prints what is wrong, and fails if anything is.

- Every public header has a documented symbol in a group, and the convenience header of its part includes it, unless it needs a
  library such as Eigen.
- Every public class, member, function, type and enumerator has a description; that of a class or function is a full sentence,
  and that of a function starts with a verb in the lower case, as in "returns".
- Every parameter of a function is described, or at least named in its description; so are its template parameters, and what it
  returns. Functions of the same name, such as the overloads and what the models of a concept have, may share their descriptions.
- The named parameters that the functions of a name read, according to the sources of the package, are those in their tables, each with a
  description, a type and a default.
- Every concept names its models, and every model its concepts.
- The classified list of the package has every class, concept, function and enumeration, with a link.
- A name of the package in the text is a link, but in the description of the thing itself. In the user manual, this holds for
  full names.
- Which room of internal/ includes files of which others, and which part those of others, is what CONTRIBUTING.md says. No rooms,
  parts and public headers include each other in a circle."""

import collections
import graphlib
import pathlib
import re
import sys
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADERS = ROOT / "include/CGAL/Spherical_parameterization"
CONTRIBUTING = ROOT / "CONTRIBUTING.md"
CONVENIENCE_HEADER = ROOT / "include/CGAL/spherical_parameterization.h"
NAMESPACE = "CGAL::Spherical_parameterization::"
VERB = re.compile(r"(\w*s|called)\b")
CLASS_KINDS = ("class", "struct")
TAG = re.compile(r"internal_np::([a-z]\w*?)(?:_t)?\b")
FOLDER = "CGAL/Spherical_parameterization/"
PACKAGE_INCLUDE = re.compile(rf"#include <{FOLDER}([\w/]+\.h)>")
PARTS = ("Sampling", "Surface_maps", "Harmonics", "Cortex", "Repair")
# what not every user has
NEEDS_A_LIBRARY = re.compile(r"CGAL_EIGEN3_ENABLED|#include <(png|Imf\w*|zlib|expat)\.h>")
# CGAL's tag of a named parameter, where its name is another one
NAMES_OF_TAGS = {"vertex_point": "vertex_point_map"}

complaints = []


def complain(place, text):
    complaints.append(f"{place}: {text}")


def text_of(element):
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def description_of(element):
    """The text of the description, without lists of parameters and the like."""
    parts = []

    def collect(node):
        if node.tag in ("parameterlist", "simplesect", "variablelist"):
            return
        parts.append(node.text or "")
        for child in node:
            collect(child)
            parts.append(child.tail or "")

    for tag in ("briefdescription", "detaileddescription"):
        collect(element.find(tag))
    return " ".join("".join(parts).split())


class Entry:
    """A class, a concept, or a member of one or of the namespace."""

    def __init__(self, element, name, section=""):
        self.element = element
        self.name = name
        self.section = section  # what is said of all members that it stands among
        self.kind = element.get("kind")
        self.file = element.find("location").get("declfile") or element.find("location").get("file")
        self.brief = text_of(element.find("briefdescription"))

    def parameters(self, kind):
        lists = self.element.findall(f"detaileddescription//parameterlist[@kind='{kind}']")
        return [text_of(name) for l in lists for name in l.iter("parametername")]

    def terms(self, *titles):
        """The lists below one of the titles, such as "Has models"."""
        result = []
        for variables in self.element.findall(".//variablelist"):
            if text_of(variables.find("varlistentry/term")) in titles:
                result += variables.findall("listitem")
        return result

    def named_parameters(self):
        """The names in the table, each with its description: lines that start with "Type:" and so on."""
        result = {}
        for item in self.terms("Optional Named Parameters"):
            for cell in item.iter("entry"):
                result[text_of(cell.find("para/bold"))] = [text_of(line) for line in cell.iter("listitem")]
        return result


def qualified_name(member):
    """The name of a function, an enumeration or a value with its namespace."""
    member_name = text_of(member.find("name"))
    definition = member.find("definition")
    names = re.findall(r"CGAL::[\w:]+", text_of(definition) if definition is not None else "")
    return names[-1] if names and names[-1].endswith("::" + member_name) else NAMESPACE + member_name


def read_entries(folder):
    """All documented or undocumented public classes, concepts and members, and the groups that they are in."""
    entries, groups, pages = [], collections.defaultdict(set), []
    for file in sorted(folder.glob("*.xml")):
        root = xml.etree.ElementTree.parse(file).getroot()
        for compound in root.findall("compounddef"):
            kind, name = compound.get("kind"), text_of(compound.find("compoundname"))
            if kind in CLASS_KINDS and compound.get("prot") == "public":
                entries.append(Entry(compound, name))
                for section in compound.findall("sectiondef"):
                    for member in section.findall("memberdef"):
                        if member.get("prot") == "public":
                            entries.append(Entry(member, f"{name}::{text_of(member.find('name'))}",
                                                 text_of(section.find("description"))))
            elif kind == "namespace" and (name + "::").startswith(NAMESPACE):
                for member in compound.iter("memberdef"):
                    entries.append(Entry(member, f"{name}::{text_of(member.find('name'))}"))
            elif kind == "group":
                for inner in compound.findall("innerclass"):
                    groups[text_of(inner)].add(name)
                for member in compound.iter("memberdef"):
                    groups[qualified_name(member)].add(name)
                pages.append((f"group {name}", compound))
            elif kind == "page":
                pages.append((f"page {name}", compound))
    return entries, groups, pages


def check_description(entry):
    is_function = entry.kind == "function"
    if not description_of(entry.element):
        complain(entry.name, "not documented")
        return
    if entry.kind == "enum":
        for value in entry.element.findall("enumvalue"):
            if not description_of(value):
                complain(f"{entry.name}::{text_of(value.find('name'))}", "not documented")
    if is_function or entry.kind in CLASS_KINDS or entry.kind == "enum":
        if not entry.brief.endswith(".") or re.search(r"\b(eq|e\.g|i\.e|cf)\.$", entry.brief):
            complain(entry.name, f"the brief description ends in mid-sentence: '... {entry.brief[-40:]}'")
    if is_function and not VERB.match(entry.brief):
        complain(entry.name, f"the brief description does not start with a verb: '{entry.brief[:40]} ...'")


def described_parameters(entries):
    """For each name of a function, the parameters and template parameters that one of the functions of the name describes."""
    result = collections.defaultdict(set)
    for entry in entries:
        result[last_name(entry)].update(entry.parameters("param"), entry.parameters("templateparam"))
    return result


def last_name(entry):
    return entry.name.rsplit("::", 1)[-1]


def check_parameters(entry, described):
    named = {text_of(code) for tag in ("briefdescription", "detaileddescription")
             for code in entry.element.find(tag).iter("computeroutput")}
    # What is called like the function itself is what the function is about.
    known = described[last_name(entry)] | named | {last_name(entry)}
    for parameter in entry.element.findall("param"):
        name = text_of(parameter.find("declname"))
        if name and name not in known:
            complain(entry.name, f"the parameter {name} is not described")
    for parameter in entry.element.findall("templateparamlist/param"):
        name = text_of(parameter.find("declname")) or text_of(parameter.find("type")).split()[-1]
        if name not in known:
            complain(entry.name, f"the template parameter {name} is not described")
    for name in entry.parameters("templateparam"):
        if name not in text_of(entry.element.find("templateparamlist")):
            complain(entry.name, f"there is no template parameter {name}")


def check_result(entries):
    """That what is returned is described, for one of the functions of a name or for all members of a section."""
    described = {last_name(e) for e in entries if re.search(r"^returns\b|\band returns\b", e.brief) or
                 re.search(r"\breturns\b", e.section) or
                 e.element.find("detaileddescription//simplesect[@kind='return']") is not None}
    for entry in entries:
        if text_of(entry.element.find("type")) not in ("", "void") and last_name(entry) not in described:
            complain(entry.name, "what it returns is not described")


def without_comments(source):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", source, flags=re.DOTALL)


def tags_read_by(header, visited):
    """The tags of named parameters that are read in a header of the package, or in one that it includes. What can be compiled
    once knows no named parameters."""
    if header in visited or header.endswith("_impl.h"):
        return set()
    visited.add(header)
    source = without_comments((HEADERS / header).read_text())
    return set(re.findall(TAG, source)).union(
        *(tags_read_by(other, visited) for other in re.findall(PACKAGE_INCLUDE, source)))


def check_named_parameters(entries):
    functions = collections.defaultdict(list)
    for entry in entries:
        if entry.file.startswith(FOLDER) and "NamedParameters" in text_of(entry.element.find("templateparamlist")):
            functions[last_name(entry)].append(entry)
    for name, namesakes in functions.items():
        visited = set()
        tags = set().union(*(tags_read_by(entry.file[len(FOLDER):], visited) for entry in namesakes))
        expected = {NAMES_OF_TAGS.get(tag, tag) for tag in tags}
        table = {parameter: lines for entry in namesakes for parameter, lines in entry.named_parameters().items()}
        for parameter in sorted(expected - set(table)):
            complain(name, f"reads the named parameter {parameter}, which is in no table")
        for parameter in sorted(set(table) - expected):
            complain(name, f"does not read the named parameter {parameter} in its table")
        for parameter, lines in table.items():
            for title in ("Type:", "Default:"):
                if not any(line.startswith(title) for line in lines):
                    complain(name, f"the named parameter {parameter} has no {title[:-1].lower()}")
            if not lines or re.match(r"(Type|Default|Extra):", lines[0]):
                complain(name, f"the named parameter {parameter} has no description")


def bare(name):
    """The name without arguments of a template and without the namespace."""
    return re.sub(r"<.*|\(\)$", "", name).replace(NAMESPACE, "").strip()


def check_concepts(concepts, classes):
    has_models = {c.name: {bare(text_of(item)) for item in c.terms("Has models")} - {""} for c in concepts}
    is_model_of = collections.defaultdict(set)
    for entry in classes:
        for item in entry.terms("Is model of"):
            if text_of(item) not in has_models and item.find(".//ref") is None:
                complain(entry.name, f"is said to be a model of {text_of(item)}, which is no concept that is known")
            is_model_of[text_of(item)].add(bare(entry.name))
    for concept, models in has_models.items():
        if not models:
            complain(concept, "names no model")
        for model in sorted(models - is_model_of[concept]):
            complain(concept, f"names {model} as a model, which does not say so")
        for model in sorted(is_model_of[concept] - models):
            complain(concept, f"does not name its model {model}")


def check_classified_list(names, pages):
    listed = set()
    for name, page in pages:
        if name == "group PkgSphericalParameterizationRef":
            for item in page.findall("detaileddescription//listitem"):
                listed.add(bare(text_of(item)))
                if item.find(".//ref") is None:
                    complain("PackageDescription.txt", f"{text_of(item)} in the classified list is no link")
    for name in sorted(names - listed):
        complain("PackageDescription.txt", f"{name} is not in the classified list")
    for name in sorted(listed - names):
        complain("PackageDescription.txt", f"{name} in the classified list is nothing of the package")


def check_links(places, names):
    for place, element in places:
        own = set(bare(place).split("::"))
        linked = {id(code) for reference in element.iter("ref") for code in reference.iter("computeroutput")}
        for code in element.iter("computeroutput"):
            text = text_of(code)
            # Where a page of the user manual drops the namespace, it means to spare the reader a link.
            if place.startswith("page ") and not text.startswith(NAMESPACE):
                continue
            if bare(text) in names - own and code.find(".//ref") is None and id(code) not in linked:
                complain(place, f"`{text}` is not a link")


def included_by(convenience_header):
    """The headers of the package that one includes, directly or through others."""
    included = set()

    def follow(source):
        for header in set(re.findall(PACKAGE_INCLUDE, source)) - included:
            included.add(header)
            follow((HEADERS / header).read_text())

    follow(convenience_header.read_text())
    return included


def check_headers(entries, groups):
    described = {f"{FOLDER}{pathlib.Path(e.file).relative_to(FOLDER)}" for e in entries
                 if groups.get(e.name) and e.file.startswith(FOLDER)}
    for folder, convenience_header in ((HEADERS, CONVENIENCE_HEADER),
                                       *((HEADERS / part, HEADERS / f"{part.lower()}.h") for part in PARTS)):
        included = included_by(convenience_header)
        for file in sorted(folder.glob("*.h")):
            header = str(file.relative_to(HEADERS))
            if file.stem in map(str.lower, PARTS):
                continue
            if FOLDER + header not in described:
                complain(header, "documents nothing that is in a group")
            if header not in included and not needs_a_library(header):
                complain(header, f"not included by {convenience_header.name}")


def needs_a_library(header):
    """Whether a header needs what not every user has; such headers are included by their names."""
    return any(NEEDS_A_LIBRARY.search((HEADERS / other).read_text())
               for other in {header} | included_by(HEADERS / header))


def part_of(header):
    """The part that a header belongs to; the core if none."""
    part = header.split("/")[0]
    return next((name for name in PARTS if part in (name, f"{name.lower()}.h")), "core")


def check_rooms():
    """That rooms of the core, and parts, include what CONTRIBUTING.md says, and no more."""
    def room_of(header):
        """The room of a header of the core, or a public header itself; for others, their part."""
        if part_of(header) != "core":
            return part_of(header) + "/"
        return header.split("/")[1] + "/" if header.startswith("internal/") and header.count("/") == 2 else header

    included = collections.defaultdict(set)
    for header in sorted(str(file.relative_to(HEADERS)) for file in HEADERS.rglob("*.h")):
        others = re.findall(PACKAGE_INCLUDE, (HEADERS / header).read_text())
        # begin_arithmetic.h and end_arithmetic.h are everywhere, and include nothing
        others = [other for other in others if not other.endswith("_arithmetic.h")]
        included[room_of(header)] |= {room_of(other) for other in others} - {room_of(header)}
    try:
        graphlib.TopologicalSorter(included).prepare()
    except graphlib.CycleError as error:
        complain("include", "a circle: " + " is included by ".join(error.args[1]))

    rows = re.findall(r"^\| `(\w+/)` \| (`.*|no other|all of these) \|$", CONTRIBUTING.read_text(), re.MULTILINE)
    described = {room: set(re.findall(r"`(\w+/)`", others)) for room, others in rows}
    parts = {f"{part}/" for part in PARTS}
    for room in sorted({room for room in included if room.endswith("/")} | set(described)):
        # what stands on all rooms of the core is not repeated for parts
        others = {other for other in included[room] if other.endswith("/") and (room not in parts or other in parts)}
        if others != described.get(room):
            complain(CONTRIBUTING.name, f"{room} includes files of {others}, not of {described.get(room)}")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    entries, groups, pages = read_entries(pathlib.Path(sys.argv[1]))
    concepts = [e for e in entries if e.kind in CLASS_KINDS and e.file.startswith("Concepts/")]
    classes = [e for e in entries if e.kind in CLASS_KINDS and e.name.startswith(NAMESPACE)]
    if not concepts or not classes:
        sys.exit(f"{sys.argv[1]}: no classes or no concepts of the package in there")

    described = described_parameters(entries)
    for entry in entries:
        check_description(entry)
        check_parameters(entry, described)
        if entry.name.count("::") - entry.name.startswith(NAMESPACE) * 2 == 0 and not groups.get(entry.name):
            complain(entry.name, "in no group")
    functions = [e for e in entries if e.kind == "function"]
    check_result(functions)
    check_named_parameters(functions)
    check_concepts(concepts, classes)
    top_level = {bare(e.name) for e in entries if "::" not in bare(e.name).removeprefix("IO::")}
    check_classified_list(top_level, pages)
    check_links([(e.name, e.element) for e in entries if e.kind not in CLASS_KINDS] +
                [(e.name, e.element.find("detaileddescription")) for e in concepts + classes] +
                [(e.name, e.element.find("briefdescription")) for e in concepts + classes] + pages,
                {bare(e.name) for e in concepts + classes})
    check_headers(entries, groups)
    check_rooms()

    for complaint in complaints:
        print(complaint, file=sys.stderr)
    if complaints:
        sys.exit(f"{len(complaints)} faults in the documentation.")
    print(f"{len(entries)} symbols are documented, {len(concepts)} concepts and {len(classes)} classes among them.")


main()
