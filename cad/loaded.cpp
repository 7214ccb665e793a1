// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "loaded.h"

#include <IGESData_IGESEntity.hxx>
#include <IGESSolid_ManifoldSolid.hxx>
#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_ReportEntity.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_UndefinedEntity.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationRelationship.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <string>
#include <vector>

#include "problem.h"

namespace findspace::cad {
namespace {

using io::CadFault;
using Entity = Handle(Standard_Transient);
using Model = Handle(Interface_InterfaceModel);

template <class... Kinds>
bool is_one_of(const Entity& entity) {
  return (entity->IsKind(STANDARD_TYPE(Kinds)) || ...);
}

bool is_iges(const Model& model) { return Handle(StepData_StepModel)::DownCast(model).IsNull(); }

/// "#274 (MANIFOLD_SOLID_BREP)" as the file has it, "D12 (186)" of IGES.
std::string name_of(const Model& model, const Entity& entity) {
  const Handle(TCollection_HAsciiString) label = model->StringLabel(entity);
  std::string kind;
  if (const auto unknown = Handle(StepData_UndefinedEntity)::DownCast(entity); !unknown.IsNull())
    kind = unknown->StepType();
  else if (const auto iges = Handle(IGESData_IGESEntity)::DownCast(entity); !iges.IsNull())
    kind = "type " + std::to_string(iges->TypeNumber());
  else
    kind = model->TypeName(entity, Standard_False);
  return (label.IsNull() ? std::string("an entity") : std::string(label->ToCString())) +
         (kind.empty() ? "" : " (" + kind + ")");
}

class Loaded {
 public:
  explicit Loaded(const Handle(XSControl_WorkSession) & session)
      : model_(session->Model()), graph_(session->Graph()), reached_(std::size_t(model_->NbEntities()) + 1) {}

  void check() {
    if (const Handle(Interface_Check) whole = model_->GlobalCheck(); !whole.IsNull() && whole->HasFailed())
      fail(CadFault::kSyntax, std::string("Open CASCADE cannot read all of it: ") + whole->CFail(1));
    for (int k = 1; k <= model_->NbEntities(); ++k) {
      if (is_root(model_->Value(k))) reach(k);
      if (unknown(k)) require_apart(k);
    }
    for (; !waiting_.empty();) {
      const int k = waiting_.back();
      waiting_.pop_back();
      require_known(k);
      for (Interface_EntityIterator at = graph_.Shareds(model_->Value(k)); at.More(); at.Next())
        reach(model_->Number(at.Value()));
    }
  }

 private:
  bool is_root(const Entity& entity) const {
    if (is_iges(model_)) return true;
    return is_one_of<StepShape_ShapeRepresentation, StepShape_ShapeDefinitionRepresentation,
                     StepShape_ContextDependentShapeRepresentation, StepRepr_RepresentationRelationship,
                     StepRepr_NextAssemblyUsageOccurrence>(entity);
  }

  bool unknown(int k) const { return is_one_of<StepData_UndefinedEntity>(model_->Value(k)); }

  /// A likely cause: what refers to an entity of an unknown kind is damaged.
  std::string first_unknown() const {
    for (int k = 1; k <= model_->NbEntities(); ++k)
      if (unknown(k)) return "; of no known kind is " + name_of(model_, model_->Value(k));
    return "";
  }

  void reach(int k) {
    if (k <= 0 || reached_[std::size_t(k)]) return;
    reached_[std::size_t(k)] = true;
    waiting_.push_back(k);
  }

  void require_known(int k) const {
    const Handle(Interface_Check)& check = model_->Check(k, Standard_True);
    const std::string name = name_of(model_, model_->Value(k));
    if (!check.IsNull() && check->HasFailed())
      fail(CadFault::kSyntax, name + " is damaged: " + check->CFail(1) + first_unknown());
    if (model_->IsErrorEntity(k)) fail(CadFault::kSyntax, name + " is damaged" + first_unknown());
    if (unknown(k))
      fail(CadFault::kUnsupported, name + " is of a kind that Open CASCADE does not know, and a shape needs it");
  }

  /// An unknown entity could say where parts lie, or which shape is whose.
  void require_apart(int k) const {
    for (Interface_EntityIterator at = graph_.Shareds(model_->Value(k)); at.More(); at.Next())
      if (is_one_of<StepBasic_ProductDefinition, StepShape_ShapeRepresentation, StepRepr_RepresentationRelationship,
                    StepRepr_ItemDefinedTransformation>(at.Value()))
        fail(CadFault::kUnsupported, name_of(model_, model_->Value(k)) +
                                         " is of a kind that Open CASCADE does not know, and it refers to " +
                                         name_of(model_, at.Value()));
  }

  Model model_;
  const Interface_Graph& graph_;
  std::vector<bool> reached_;
  std::vector<int> waiting_;
};

}  // namespace

void require_loaded(const Handle(XSControl_WorkSession) & session) { Loaded(session).check(); }

void require_translated(const Handle(XSControl_WorkSession) & session) {
  const Model model = session->Model();
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  for (int k = 1; k <= model->NbEntities(); ++k) {
    const Entity& entity = model->Value(k);
    if (!is_one_of<StepShape_SolidModel, IGESSolid_ManifoldSolid>(entity)) continue;
    const Handle(Transfer_Binder) found = process->Find(entity);
    if (!found.IsNull() && found->HasResult()) continue;
    std::string why;
    if (!found.IsNull() && found->Check()->HasFailed()) why = std::string(": ") + found->Check()->CFail(1);
    fail(CadFault::kGeometry, name_of(model, entity) + " is a solid that Open CASCADE could not translate" + why);
  }
}

}  // namespace findspace::cad
