# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Every public name of include/findspace is in Python: by the same name, by another one, or with a reason why not."""
import pathlib
import re

import findspace as fs

HEADERS = sorted((pathlib.Path(__file__).parents[2] / "include" / "findspace").glob("*.h"))

# Names of C++ that are called otherwise in Python; of a type its members are looked for there, too.
ELSEWHERE = {
    "AdjustedPhi::Value": "AdjustedPhiValue", "AdjustedPhi::at": "AdjustedPhi.__call__",
    "Phi::Value": "PhiValue", "Phi::at": "Phi.__call__", "PhiQuestion": "Phi.text",
    "BoardOptions": "Board.file", "BoardQuestion": "Board.scene", "StoreScope": "ResultStore.__enter__", "BoardGroup": "Board.file", "Board::options": "Board.__getstate__",
    "Telling": "Answer.text", "NearestPlace": "Answer.nearest", "Pose": "Scene.check", "MapQuestion": "Scene.map", "CheckQuestion": "Scene.check", "ShapeQuestion": "Scene.describe", "MapLines": "Scene.map", "PlaceQuestion": "Scene.place",
    "PlaceQuestion::Near": "Scene.place", "Scene::Question": "Scene.asking",
    "Scene::with": "Scene.limited", "Scene::motion": "World.motion",
    "Demands": "place", "Placement::Positions": "Placement.positions", "WorldOptions": "World",
    "Interval::from": "Interval.start", "Interval::to": "Interval.end", "Interval::from_belongs": "Interval.start_belongs",
    "Interval::to_belongs": "Interval.end_belongs", "PoseMap::Sector::from": "PoseMap.Sector.start",
    "PoseMap::Sector::to": "PoseMap.Sector.end",
    "Lines": "World.on_lines", "LineMap::Line": "LineMap.lines", "VolumeBounds": "World.volume",
    "Motion": "World.motion", "WayPoint": "World.motion", "RegionBounds": "World.solve_bounds", "OnLine": "World.on_line",
    "World::with": "World.limited", "ShapeGroups": "World.grouped", "SpaceQuestion": "World.solve_space", "Nearest3": "Query.nearest",
    "Contour": "Shape.contour", "HeightField": "Shape.height_field", "Grid": "Shape.grid", "Shape::rounded": "Shape.rounded_points",
    "Shape::Rounded": "Shape.rounded_points", "Shape::Rounded::points": "Shape.rounded_points",
    "Shape::Rounded::largest": "Shape.largest_move",
    "Shape::regularize": "Shape.regularized", "Shape::reflect": "Shape.reflected",
    "Bounds": "Region.bounds", "ExactPoint": "Ring.exact_vertices", "Exact": "Ring.exact_vertices",
    "Region::Component": "Component", "Region::Component::isolated": "Component.points", "Region::Ring": "Ring",
    "Region::Side": "Ring.edges", "Region::Edge": "Edge", "Region::Edge::arc": "Edge.is_arc",
    "Region::Vertex": "Ring.vertices", "Region::Vertex::belongs": "Ring.belong", "Region::Nearest": "Region.nearest",
    "Region::vertices": "Ring.vertices", "Region::edges": "Ring.edges", "Region::exact": "Ring.exact_vertices",
    "Region::Drawn": "Region.drawn", "Region::Paths": "Region.paths", "SpaceRegion::Thin": "SpaceRegion.thin", "SpaceRegion::Bounds3": "SpaceRegion.bounds", "SpaceRegion::Box": "SpaceRegion.boxes",
    "PackSearch": "Packing.search", "PackPeers": "Packing.search", "PackReading": "Packing.json",
    "PackPart::of": "PackPart", "PackGap": "PackProblem.gaps", "PackCondition": "PackProblem.conditions",
    "FixedPart::x": "FixedPart.at", "FixedPart::y": "FixedPart.at", "PlacedPart::x": "PlacedPart.at",
    "PlacedPart::y": "PlacedPart.at", "PackRemnant::x": "PackRemnant.at", "PackRemnant::y": "PackRemnant.at",
    "PackRemnant::width": "PackRemnant.size", "PackRemnant::height": "PackRemnant.size",
    "PackContainer::width": "PackContainer.size", "PackContainer::depth": "PackContainer.size",
    "PackContainer::height": "PackContainer.size", "SolidPackProblem::width": "SolidPackProblem.floor",
    "SolidPackProblem::depth": "SolidPackProblem.floor",
    "Packing::svg": "PackLayout.svg", "Packing::dxf": "PackLayout.dxf", "SolidPacking::svg": "SolidPackLayout.svg",
    "SolidPacking::file": "SolidPackLayout.text", "SolidPacking::surface": "SolidPackLayout.surface",
    "layout_faults": "PackLayout.faults", "layout_json": "PackLayout.json", "layout_svg": "PackLayout.svg",
    "layout_file": "SolidPackLayout.text", "layout_surface": "SolidPackLayout.surface",
    "pack_problem": "PackProblem.json", "solid_pack_problem": "SolidPackProblem.json",
}
# Types whose values are plain ones of Python, and so are their members'.
PLAIN = {"ShapeQuestion", "BoardQuestion", "StoreScope", "Telling", "CheckQuestion", "Region::Paths", "SpaceRegion::Thin", "SpaceQuestion", "MapQuestion", "MapLines", "PlaceQuestion", "PlaceQuestion::Near",
         "NearestPlace", "Pose", "Scene::Question", "BoardOptions", "Demands", "PhiQuestion", "BoardGroup", "Placement::Positions", "Lines", "LineMap::Line", "VolumeBounds", "Motion",
         "WayPoint", "RegionBounds", "OnLine", "WorldOptions", "Nearest3", "ShapeGroups", "Contour", "Contour::Step", "HeightField", "Grid", "Bounds", "ExactPoint",
         "Exact", "Region::Side", "Region::Nearest", "Region::Drawn", "SpaceRegion::Bounds3", "SpaceRegion::Box",
         "PackSearch", "PackPeers", "PackReading", "PackGap", "PackCondition", "Region::Vertex"}
# Names that Python has no need of, and why; of a type that holds for its members, too.
NEEDLESS = {
    "ErrorCode": "text", "LevelChange::Kind": "text", "DxfVersion": "text", "CurveRule": "text", "PartRule": "text",
    "Limit": "text",
    "PackFault::Kind": "text", "Phi::State": "text", "Phi::Form": "text", "AdjustedPhi::Limit": "text",
    "Region::Towards": "text", "Shape::Axis": "text", "SpaceRegion::Form": "text", "Feature::Kind": "text",
    "PredicateWord::Level": "text",
    "Error::code": "of each exception", "Error::message": "of each exception", "Error::place": "of each exception",
    "Error::geometry": "of each exception", "Stopped::limit": "of each exception",
    "Error::at": "for those that throw it", "Error::within": "for those that throw it",
    "kUsualInput": "that of ReadOptions()", "kUsualWork": "that of ReadOptions()",
    "Number": "numbers of Python, or text", "Level": "numbers of Python, or text", "Point": "a pair", "Point3": "a triple",
    "Position": "a pair of floats", "Position3": "a triple of floats", "Place": "a list of floats",
    "CancelScope": "Ctrl-C ends questions", "ThreadScope": "threads of Options",
    "StageFiles": "FINDSPACE_DUMP of the program", "Team": "peers of a search; findspace-mpi", "TeamScope": "findspace-mpi",
    "TextSink": "texts are whole", "FileText": "open()", "write_files": "open()", "Written": "open()",
    "remove_unfinished_files": "open()", "printable": "repr()", "JsonValue": "the module json", "read_json": "the module json",
    "Scene::board_question": "pickle",
    "read_text": "open()", "read_standard_input": "sys.stdin", "json_number": "the module json",
    "json_string": "the module json", "json_list": "the module json",
    "Answer::Found": "text", "MapLines::Side": "text", "Answer::write": "texts are whole", "Answer::written_in_parts": "texts are whole",
    "Scene::Free::Kind": "text", "Scene::Listener": "notes of each answer",
    "Scene::Change": "pickle", "Scene::changes": "pickle",
    "Placement::Told": "pickle", "Placement::told": "pickle",
}


def statements(text):
    """The statements of a scope: head, and what its braces hold."""
    out, depth, parentheses, begin, body = [], 0, 0, 0, 0
    for k, c in enumerate(text):
        parentheses += (c == "(") - (c == ")")
        if c == "{":
            body = k if depth == 0 and parentheses == 0 else body
            depth += 1
        elif c == "}":
            depth -= 1
            ends = depth == 0 and parentheses == 0 and not re.match(r"\s*[;,<]", text[k + 1:])
            if ends and not re.search(r"=\s*$", text[begin:body]):
                out.append((text[begin:body], text[body + 1:k]))
                begin = k + 1
        elif c == ";" and depth == 0 and parentheses == 0:
            whole = text[begin:k]
            scope = re.search(r"\b(class|struct|enum class)\s+\w+[^;{(]*\{", whole)
            out.append((whole[:whole.index("{")], whole[whole.index("{") + 1:whole.rindex("}")]) if scope else (whole, ""))
            begin = k + 1
    return out


def members(head, prefix):
    """Of a statement that is no scope: the function, or the variables that it declares."""
    if "operator" in head or "~" in head or "std::shared_ptr<const Data>" in head or re.search(r"\bdata\(", head):
        return []
    call = re.search(r"(\w+)\(", re.sub(r"requires std::\w+<[^()]*>|std::function<[^;]*?\)>", "", head))
    if call and not re.match(r"^[^(]*=", head):
        return [prefix + call[1]]
    for inner in (r"<[^<>]*>", r"\{[^{}]*\}"):
        while re.search(inner, head):
            head = re.sub(inner, "", head)
    return [prefix + piece.split("=")[0].split()[-1] for piece in head.split(",") if piece.split("=")[0].split()]


def public_names(text, of="", public=True):
    """Names of a scope, such as "Region::Edge::start"; those of namespace findspace without it."""
    prefix, found = of and of + "::", []
    for head, body in statements(text):
        for label in re.findall(r"\b(public|private|protected)\s*:(?!:)", head):
            public = label == "public"
        head = " ".join(re.sub(r"\b(public|private|protected)\s*:(?!:)", "", head).split())
        inner = re.match(r"(?:template <[^>]*> )?(namespace|class|struct|enum class) (\w+)", head)
        using = re.match(r"using (\w+) =", head)
        if not public or not head or head.startswith("friend"):
            continue
        if using:
            found.append(prefix + using[1])
        elif inner and inner[1] == "namespace":
            found += public_names(body)
        elif inner and (not body or inner[2] in ("Data", "Limits")):
            continue
        elif inner:
            found.append(prefix + inner[2])
            found += [] if inner[1] == "enum class" else public_names(body, prefix + inner[2], inner[1] == "struct")
        else:
            found += members(head, prefix)
    return found


def all_names():
    found = []
    for path in HEADERS:
        text = re.sub(r'R"\(.*?\)"|"(\\.|[^"\\])*"', '""', re.sub(r"//[^\n]*|^#.*$", "", path.read_text(), flags=re.M))
        found += public_names(text)
    return list(dict.fromkeys(found))


def in_python(path):
    value = fs
    for name in path.split("."):
        if not hasattr(value, name):
            return False
        value = getattr(value, name)
    return True


def place(name):
    """Where Python should have it, or None where it need not."""
    if name in ELSEWHERE:
        return ELSEWHERE[name]
    scope, _, last = name.rpartition("::")
    if name in NEEDLESS or any(name.startswith(of + "::") for of in NEEDLESS):
        return None
    if scope and last == scope.rpartition("::")[2]:
        return place(scope)  # a constructor
    if scope in PLAIN:
        return place(scope)
    above = place(scope) if scope else ""
    return above and f"{above}.{last}" if scope else last


def test_the_headers_are_read_whole():
    names = all_names()
    assert len(names) > 580 and {"Region::Edge::left_belongs", "Phi::Value::active", "gap", "kUsualWork",
                                 "Options::cancel", "LevelChange::Kind", "DistanceValue::upper"} <= set(names)
    assert not [n for n in names if not re.fullmatch(r"\w+(::\w+)*", n) or n[0].isdigit()]


def test_every_public_name_is_in_python():
    missing = {name: place(name) for name in all_names() if place(name) is not None and not in_python(place(name))}
    assert missing == {}


def test_no_excuse_is_out_of_date():
    names = set(all_names())
    assert [name for name in [*ELSEWHERE, *NEEDLESS] if name not in names] == []
    assert [path for path in ELSEWHERE.values() if not in_python(path)] == []
