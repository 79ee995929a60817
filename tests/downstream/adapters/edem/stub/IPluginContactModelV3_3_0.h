#pragma once
// A stub of EDEM's contact model API 3.3: of its types and functions those that plugins/edem asks for, under their names.
#include <cmath>

#define EXPORT_MACRO extern "C"

namespace NApi {
enum ECalculateResult { eSuccess };
enum EPluginPropertyCategory { eContact, eParticle };
enum EPluginPropertyDataTypes { eDouble };
enum EPluginPropertyUnitTypes { eNone };
enum class EPluginModelType { eBase, eOptional };
enum class EPluginExecutionChainPosition { eBasePos, eAfterBasePos };
constexpr int CUSTOM_PROP_MAX_NAME_LENGTH = 64, BUFF_SIZE = 256;
inline char delim() { return '|'; }
} // namespace NApi

namespace NApiHelpersV3_0_0 {
class CSimple3DVector {
 public:
  CSimple3DVector(double x = 0, double y = 0, double z = 0) : v_{x, y, z} {}
  double getX() const { return v_[0]; }
  double getY() const { return v_[1]; }
  double getZ() const { return v_[2]; }
  double dot(const CSimple3DVector& o) const { return v_[0] * o.v_[0] + v_[1] * o.v_[1] + v_[2] * o.v_[2]; }
  double length() const { return std::sqrt(dot(*this)); }
  void normalise() { *this = *this * (1 / length()); }
  CSimple3DVector operator+(const CSimple3DVector& o) const { return {v_[0] + o.v_[0], v_[1] + o.v_[1], v_[2] + o.v_[2]}; }
  CSimple3DVector operator-(const CSimple3DVector& o) const { return *this + o * -1; }
  CSimple3DVector operator*(double s) const { return {v_[0] * s, v_[1] * s, v_[2] * s}; }
  CSimple3DVector& operator+=(const CSimple3DVector& o) { return *this = *this + o; }

 private:
  double v_[3];
};
} // namespace NApiHelpersV3_0_0

namespace NCalcForceTypesV3_0_0 {
using Vector = NApiHelpersV3_0_0::CSimple3DVector;
struct STimeStepData {
  double time = 0, timeStep = 0;
};
struct SDiscreteElement {
  bool isSphere = true;
  double mass = 0, physicalRadius = 0;
  Vector position, velocityAtContactPoint;
};
struct SInteraction {
  double coeffRest = 1, staticFriction = 0, rollingFriction = 0;
};
struct SContact {
  Vector contactPoint;
  double normalPhysicalOverlap = 0;
};
struct SContactResult {
  Vector normalForce, usNormalForce, tangentialForce, usTangentialForce;
};
} // namespace NCalcForceTypesV3_0_0

namespace NApiCore {
enum { eContactCustomPropertyManager };
struct IApiManager_1_0 {
  virtual void* getApi(int which, int major, int minor) = 0;
};
struct ICustomPropertyManagerApi_1_0 {
  virtual unsigned int getPropertyIndex(const char* name) = 0;
};
struct ICustomPropertyDataApi_1_0 {
  virtual const double* getValue(unsigned int index) = 0;
  virtual double* getDelta(unsigned int index) = 0;
};
} // namespace NApiCore

namespace NApiCm {
class IPluginContactModel {
 public:
  virtual ~IPluginContactModel() = default;
};
class IPluginContactModelV3_3_0 : public IPluginContactModel {
 public:
  using Data = NApiCore::ICustomPropertyDataApi_1_0;
  virtual bool isThreadSafe() = 0;
  virtual bool usesCustomProperties() = 0;
  virtual NApi::EPluginModelType getModelType() = 0;
  virtual NApi::EPluginExecutionChainPosition getExecutionChainPosition() = 0;
  virtual bool starting(NApiCore::IApiManager_1_0&, int threads) = 0;
  virtual unsigned int getNumberOfRequiredProperties(const NApi::EPluginPropertyCategory) = 0;
  virtual bool getDetailsForProperty(unsigned int, NApi::EPluginPropertyCategory, char[], NApi::EPluginPropertyDataTypes&,
                                     unsigned int&, NApi::EPluginPropertyUnitTypes&, char[]) = 0;
  virtual NApi::ECalculateResult calculateForce(int, const NCalcForceTypesV3_0_0::STimeStepData&,
                                                const NCalcForceTypesV3_0_0::SDiscreteElement&, Data*,
                                                const NCalcForceTypesV3_0_0::SDiscreteElement&, Data*, Data*, Data*,
                                                const NCalcForceTypesV3_0_0::SInteraction&,
                                                const NCalcForceTypesV3_0_0::SContact&, NApiHelpersV3_0_0::CSimple3DVector&,
                                                NCalcForceTypesV3_0_0::SContactResult&) = 0;
};
} // namespace NApiCm
