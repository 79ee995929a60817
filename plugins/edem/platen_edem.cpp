// A Platen law as a contact model of EDEM (contact model API 3.3). UNTESTED INSIDE EDEM: it is compiled
// against a stub of the interface alone (tests/downstream/adapters), where its forces are those of `platen
// eval`.
//
//   platen export dem-engine granule.toml -o granule      # the law as text: functions.cu
//   compile this file with EDEM's headers and that folder on the include path, as a shared library; load it
//   as a contact model
//
// One law for all particles; a geometry is a rigid plane. EDEM's own coefficients of restitution (of an
// elastic contact, by viscous damping) and static friction (Mindlin's stiffness 8 G* a) hold; its moduli do
// not matter.
#include "functions.cu" // of the export; the law, its G* and damping

#include "ICustomPropertyManagerApi_1_0.h"
#include "IPluginContactModelV3_3_0.h"
#include "PluginContactModelCore.h"

#include <cmath>
#include <cstring>

namespace {

using NApiHelpersV3_0_0::CSimple3DVector;
using namespace NCalcForceTypesV3_0_0;

constexpr const char* memory_name = "PlatenMemory";
constexpr unsigned memory_size = 5; // largest overlap [m], tangential force [N] (3), its stiffness [N/m]

/// A Hertzian contact returns e at any velocity with c = damping sqrt(stiffness m); most have the same e.
double damping_of(double e) {
  thread_local double last = 1, damping = 0;
  if (e != last) last = e, damping = e > 0 && e < 1 ? platen_damping_of(e) : 0;
  return damping;
}

class Platen : public NApiCm::IPluginContactModelV3_3_0 {
 public:
  bool isThreadSafe() override { return true; }
  bool usesCustomProperties() override { return true; }
  NApi::EPluginModelType getModelType() override { return NApi::EPluginModelType::eBase; }
  NApi::EPluginExecutionChainPosition getExecutionChainPosition() override {
    return NApi::EPluginExecutionChainPosition::eBasePos;
  }

  unsigned int getNumberOfRequiredProperties(const NApi::EPluginPropertyCategory category) override {
    return category == NApi::eContact ? 1 : 0;
  }
  bool getDetailsForProperty(unsigned int index, NApi::EPluginPropertyCategory category,
                             char name[NApi::CUSTOM_PROP_MAX_NAME_LENGTH],
                             NApi::EPluginPropertyDataTypes& type, unsigned int& count,
                             NApi::EPluginPropertyUnitTypes& unit, char initial[NApi::BUFF_SIZE]) override {
    if (index != 0 || category != NApi::eContact) return false;
    std::strncpy(name, memory_name, NApi::CUSTOM_PROP_MAX_NAME_LENGTH);
    type = NApi::eDouble, count = memory_size, unit = NApi::eNone;
    const char zeros[] = {'0',           NApi::delim(), '0',           NApi::delim(), '0',
                          NApi::delim(), '0',           NApi::delim(), '0',           0};
    std::strncpy(initial, zeros, NApi::BUFF_SIZE);
    return true;
  }
  bool starting(NApiCore::IApiManager_1_0& manager, int) override {
    auto* properties = static_cast<NApiCore::ICustomPropertyManagerApi_1_0*>(
        manager.getApi(NApiCore::eContactCustomPropertyManager, 1, 0));
    memory_ = properties->getPropertyIndex(memory_name);
    return true;
  }

  NApi::ECalculateResult calculateForce(int, const STimeStepData& step, const SDiscreteElement& one,
                                        NApiCore::ICustomPropertyDataApi_1_0*, const SDiscreteElement& two,
                                        NApiCore::ICustomPropertyDataApi_1_0*,
                                        NApiCore::ICustomPropertyDataApi_1_0* contact_data,
                                        NApiCore::ICustomPropertyDataApi_1_0*,
                                        const SInteraction& interaction, const SContact& contact,
                                        CSimple3DVector&, SContactResult& result) override {
    const double* memory = contact_data->getValue(memory_);
    double* change = contact_data->getDelta(memory_);
    const double overlap = contact.normalPhysicalOverlap;
    if (!(overlap > 0)) { // parted
      for (unsigned k = 0; k < memory_size; ++k) change[k] = -memory[k];
      return NApi::eSuccess;
    }
    const PlatenResponse law =
        platen_contact(one.physicalRadius, two.isSphere ? two.physicalRadius : 1e300, overlap, memory[0]);

    CSimple3DVector n = one.position - (two.isSphere ? two.position : contact.contactPoint);
    n.normalise();
    const CSimple3DVector velocity = one.velocityAtContactPoint - two.velocityAtContactPoint;
    const double along = n.dot(velocity);
    const double mass = two.isSphere ? one.mass * two.mass / (one.mass + two.mass) : one.mass;
    const double c = law.force > 0 ? damping_of(interaction.coeffRest) * std::sqrt(law.stiffness * mass) : 0;
    const double normal = std::fmax(law.force - c * along, 0); // never pulls

    // the tangential force shrinks with a; friction limits it
    const double k_t = platen_shear * law.contact_radius, wide = std::fmax(memory[4], k_t);
    CSimple3DVector t(memory[1], memory[2], memory[3]);
    t = (t - n * n.dot(t)) * (wide > 0 ? k_t / wide : 0) - (velocity - n * along) * (k_t * step.timeStep);
    const double limit = normal > 0 ? interaction.staticFriction * normal : 0;
    if (t.length() > limit) t = t * (limit / t.length());

    result.normalForce += n * normal;
    result.usNormalForce += n * (normal - law.force);
    result.tangentialForce += t;
    const double now[memory_size] = {std::fmax(memory[0], overlap), t.getX(), t.getY(), t.getZ(), k_t};
    for (unsigned k = 0; k < memory_size; ++k) change[k] = now[k] - memory[k];
    return NApi::eSuccess;
  }

 private:
  unsigned int memory_ = 0;
};

} // namespace

EXPORT_MACRO NApiCm::IPluginContactModel* GETCMINSTANCE() { return new Platen; }
EXPORT_MACRO void RELEASECMINSTANCE(NApiCm::IPluginContactModel* model) { delete model; }
EXPORT_MACRO int GETCMINTERFACEVERSION() {
  return 3 << 16 | 3 << 8; // 3.3.0
}
