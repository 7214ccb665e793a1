// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The library of CAD files: STEP (AP203, AP214, AP242) and IGES by Open CASCADE. Assemblies are walked with their
// placements composed; parts keep the names of their products. Faces that no solid holds (usual in IGES) are sewn where
// their edges lie within the tolerance that the file states. Exceptions of Open CASCADE end here, and it prints
// nothing. Each file has a process of its own (child.h): Open CASCADE may crash, and it keeps settings in globals.
// Keywords: B-rep, STEP, IGES, assembly, XDE.
#include <sys/mman.h>
#include <unistd.h>

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <Standard_Failure.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cstdio>
#include <sstream>

#include "brep_mesh.h"
#include "child.h"
#include "loaded.h"
#include "problem.h"
#include "rounded.h"
#include "text_check.h"

namespace findspace::cad {
namespace {

using io::CadFault;
using io::CadProblem;

/// Runs work and takes what it throws as a problem.
template <class Work>
CadProblem guarded(Work work) {
  try {
    work();
    return {};
  } catch (const Problem& problem) {
    return problem.what;
  } catch (const Standard_Failure& failure) {
    const char* text = failure.GetMessageString();
    return {CadFault::kUnsupported, std::string("Open CASCADE gave up: ") + failure.DynamicType()->Name() +
                                        (text == nullptr || *text == 0 ? "" : std::string(": ") + text)};
  } catch (const std::bad_alloc&) {
    return {CadFault::kMemory, ""};
  }
}

struct Part {
  TopoDS_Shape solid;
  std::string name, place;
  std::vector<std::string> assemblies{};
};

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  const TCollection_AsciiString text(name->Get());
  const std::string out(text.ToCString());
  // Names that Open CASCADE makes up itself: where a component comes from, and kinds of shapes.
  if (out.rfind("=>[", 0) == 0 || out == "SOLID" || out == "COMPOUND" || out == "SHELL" || out == "ASSEMBLY") return "";
  return out;
}

std::string place_text(const gp_Pnt& p) {
  char text[100];
  std::snprintf(text, sizeof text, "(%g, %g, %g)", p.X(), p.Y(), p.Z());
  return text;
}

/// Edges of one face alone: how many, and where the first is.
void require_closed(const TopoDS_Shape& shell, const std::string& what) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shell, TopAbs_EDGE, TopAbs_FACE, faces);
  int open = 0;
  std::string first;
  for (int k = 1; k <= faces.Extent(); ++k) {
    const TopoDS_Edge edge = TopoDS::Edge(faces.FindKey(k));
    if (faces(k).Extent() != 1 || BRep_Tool::Degenerated(edge)) continue;
    int uses = 0;  // a seam is used twice by its face
    for (TopExp_Explorer at(faces(k).First(), TopAbs_EDGE); at.More(); at.Next()) uses += at.Current().IsSame(edge);
    if (uses != 1) continue;
    double from = 0, to = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
    if (open++ == 0 && !curve.IsNull()) first = " near " + place_text(curve->Value((from + to) / 2)) + " mm";
  }
  if (open > 0)
    fail(CadFault::kGeometry, what + " is not closed: " + std::to_string(open) +
                                  (open == 1 ? " edge belongs to one face only" : " edges belong to one face only") +
                                  first);
}

class File : public io::CadFile {
 public:
  void read_step(const std::string& bytes) {
    check_step_text(bytes);
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    STEPCAFControl_Reader reader;
    std::istringstream stream(bytes);
    if (reader.ChangeReader().ReadStream("", stream) != IFSelect_RetDone)
      fail(CadFault::kSyntax, "Open CASCADE cannot read this as STEP: it is cut off, or not well formed");
    require_loaded(reader.Reader().WS());
    Handle(TDocStd_Document) document = new TDocStd_Document("");
    reader.SetNameMode(true);
    reader.SetColorMode(false);
    reader.SetLayerMode(false);
    reader.SetPropsMode(false);
    if (!reader.Transfer(document)) nothing();
    require_translated(reader.Reader().WS());
    take(document);
  }

  /// The reader of IGES opens files by name, so the bytes get one in memory.
  void read_iges(const std::string& bytes) {
    check_iges_text(bytes);
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    const int file = memfd_create("findspace", MFD_CLOEXEC);
    const auto close_it = [&] { close(file); };
    if (file < 0) fail(CadFault::kFile, "no file in memory could be made");
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t n = write(file, bytes.data() + at, bytes.size() - at);
      if (n <= 0) {
        close_it();
        fail(CadFault::kFile, "the file does not fit in memory");
      }
      at += std::size_t(n);
    }
    IGESCAFControl_Reader reader;
    const std::string name = "/proc/self/fd/" + std::to_string(file);
    const IFSelect_ReturnStatus status = reader.ReadFile(name.c_str());
    close_it();
    if (status != IFSelect_RetDone)
      fail(CadFault::kSyntax, "Open CASCADE cannot read this as IGES: it is cut off, or not well formed");
    require_loaded(reader.WS());
    Handle(TDocStd_Document) document = new TDocStd_Document("");
    reader.SetNameMode(true);
    reader.SetColorMode(false);
    reader.SetLayerMode(false);
    if (!reader.Transfer(document)) nothing();
    require_translated(reader.WS());
    take(document);
  }

  std::size_t solids() const override { return parts_.size(); }
  std::string name(std::size_t k) const override { return parts_[k].name; }
  std::string place_name(std::size_t k) const override { return parts_[k].place; }
  std::vector<std::string> assemblies(std::size_t k) const override { return parts_[k].assemblies; }
  std::optional<io::CadRounded> rounded(std::size_t k) const override {
    std::optional<io::CadRounded> out;
    const CadProblem problem = guarded([&] { out = rounded_of(parts_[k].solid); });
    return problem.fault == CadFault::kNone ? out : std::nullopt;
  }
  CadProblem mesh(std::size_t k, double tolerance, std::size_t most, io::CadMesh& out) const override {
    return guarded([&] { out = mesh_of(parts_[k].solid, tolerance, most); });
  }
  std::vector<std::string> notes() const override { return notes_; }

 private:
  [[noreturn]] static void nothing() { fail(CadFault::kGeometry, "there is no solid in it"); }

  void take(const Handle(TDocStd_Document) & document) {
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    TDF_LabelSequence roots;
    shapes->GetFreeShapes(roots);
    for (int k = 1; k <= roots.Length(); ++k) walk(roots(k), TopLoc_Location(), "", 0);
    if (parts_.empty()) nothing();
  }

  void walk(const TDF_Label& label, const TopLoc_Location& placed, const std::string& place, int depth) {
    if (depth > kMostDepth) fail(CadFault::kGeometry, "the assembly is more than 64 levels deep");
    if (!XCAFDoc_ShapeTool::IsAssembly(label)) {
      leaf(XCAFDoc_ShapeTool::GetShape(label).Moved(placed), name_of(label), place);
      return;
    }
    const std::size_t first = parts_.size();
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    for (int k = 1; k <= components.Length(); ++k) {
      TDF_Label part;
      if (!XCAFDoc_ShapeTool::GetReferredShape(components(k), part)) continue;
      walk(part, placed * XCAFDoc_ShapeTool::GetLocation(components(k)), name_of(components(k)), depth + 1);
    }
    for (std::size_t k = first; k < parts_.size(); ++k)
      for (const std::string& name : {name_of(label), place})
        if (!name.empty()) parts_[k].assemblies.push_back(name);
  }

  void leaf(const TopoDS_Shape& shape, const std::string& name, const std::string& place) {
    const std::string what = name.empty() ? "the shape" : "'" + name + "'";
    if (parts_.size() > kMostParts) fail(CadFault::kUnsupported, "there are more than 10,000 solids");
    for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next()) {
      require_closed(at.Current(), what);
      parts_.push_back({smooth_faces(at.Current()), name, place});
    }
    const double tolerance = ShapeAnalysis_ShapeTolerance().Tolerance(shape, 1);
    BRepBuilderAPI_Sewing sewing(std::max(tolerance, kLeastSewing));
    int loose = 0;
    for (TopExp_Explorer at(shape, TopAbs_FACE, TopAbs_SOLID); at.More(); at.Next(), ++loose) sewing.Add(at.Current());
    if (loose == 0) return;
    sewing.Perform();
    int shells = 0;
    for (TopExp_Explorer at(sewing.SewedShape(), TopAbs_SHELL); at.More(); at.Next(), ++shells)
      sewn(at.Current(), what, name, place);
    TopExp_Explorer alone(sewing.SewedShape(), TopAbs_FACE, TopAbs_SHELL);
    if (alone.More()) {
      if (shells == 0 && loose == 1)
        require_one(alone.Current(), what, name, place);
      else
        require_closed(alone.Current(), what);
    }
    notes_.push_back((name.empty() ? std::string() : name + ": ") + std::to_string(loose) +
                     (loose == 1 ? " face" : " faces") + " that no solid holds bound a closed surface");
  }

  /// One face that is closed by itself: a sphere, a torus.
  void require_one(const TopoDS_Shape& face, const std::string& what, const std::string& name,
                   const std::string& place) {
    require_closed(face, what);
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    builder.Add(shell, face);
    sewn(shell, what, name, place);
  }

  void sewn(const TopoDS_Shape& shell, const std::string& what, const std::string& name, const std::string& place) {
    require_closed(shell, what);
    TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell)).Solid();
    BRepLib::OrientClosedSolid(solid);
    parts_.push_back({smooth_faces(solid), name, place});
  }

  static constexpr int kMostDepth = 64;
  static constexpr std::size_t kMostParts = 10000;
  static constexpr double kLeastSewing = 0.0001;  // mm
  std::vector<Part> parts_;
  std::vector<std::string> notes_;
};

void silence() {
  static const bool done = [] {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    return true;
  }();
  static_cast<void>(done);
}

std::unique_ptr<io::CadFile> read_here(const std::string& bytes, bool iges, CadProblem& problem) {
  auto file = std::make_unique<File>();
  problem = guarded([&] {
    silence();
    if (iges)
      file->read_iges(bytes);
    else
      file->read_step(bytes);
  });
  if (problem.fault != CadFault::kNone) return nullptr;
  return file;
}

}  // namespace
}  // namespace findspace::cad

extern "C" __attribute__((visibility("default"))) std::unique_ptr<findspace::io::CadFile> findspace_read_cad(
    const std::string& bytes, bool iges, findspace::io::CadProblem& problem) {
  return findspace::cad::read_in_child(
      [&](findspace::io::CadProblem& found) { return findspace::cad::read_here(bytes, iges, found); }, problem);
}
