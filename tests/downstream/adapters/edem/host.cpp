// EDEM, as far as the adapter sees it: reads lines "R1 R2 overlap" of one contact (R2 above 1e6: a geometry),
// writes the force on each element along the normal. With an argument: what an impact returns.
#include "platen_edem.cpp"

#include "../bounce.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

struct Data : NApiCore::ICustomPropertyDataApi_1_0 {
  double value[5] = {}, delta[5] = {};
  const double* getValue(unsigned) override { return value; }
  double* getDelta(unsigned) override { return delta; }
};
struct Manager : NApiCore::IApiManager_1_0, NApiCore::ICustomPropertyManagerApi_1_0 {
  void* getApi(int, int, int) override { return static_cast<NApiCore::ICustomPropertyManagerApi_1_0*>(this); }
  unsigned int getPropertyIndex(const char*) override { return 0; }
};

} // namespace

int main(int argc, char**) {
  auto* model = static_cast<NApiCm::IPluginContactModelV3_3_0*>(GETCMINSTANCE());
  Manager manager;
  char name[NApi::CUSTOM_PROP_MAX_NAME_LENGTH], initial[NApi::BUFF_SIZE];
  NApi::EPluginPropertyDataTypes type;
  NApi::EPluginPropertyUnitTypes unit;
  unsigned count = 0;
  if (!model->starting(manager, 1) || model->getNumberOfRequiredProperties(NApi::eContact) != 1 ||
      !model->getDetailsForProperty(0, NApi::eContact, name, type, count, unit, initial) || count != 5)
    return EXIT_FAILURE;
  Data data;
  const auto force = [&](double R1, double R2, double overlap, double v) {
    SDiscreteElement one, two;
    one.mass = two.mass = 1e-6;
    one.physicalRadius = R1, two.physicalRadius = R2, two.isSphere = R2 < 1e6;
    SContact contact;
    contact.normalPhysicalOverlap = overlap;
    one.position = {R1 - overlap, 0, 0}, one.velocityAtContactPoint = {v, 0, 0};
    if (two.isSphere) two.position = {-R2, 0, 0};
    CSimple3DVector unused;
    SContactResult result;
    if (model->calculateForce(0, {0, 1e-6}, one, nullptr, two, nullptr, &data, nullptr, {0.5, 0.3, 0},
                              contact, unused, result) != NApi::eSuccess)
      std::exit(EXIT_FAILURE);
    for (int k = 0; k < 5; ++k) data.value[k] += data.delta[k], data.delta[k] = 0;
    return result.normalForce.getX();
  };
  if (argc > 1)
    return bounce(0.5e-6, 1, 1e-9, [&](double overlap, double v) { return force(1e-3, 1e-3, overlap, v); });
  double R1, R2, overlap;
  while (std::scanf("%lf %lf %lf", &R1, &R2, &overlap) == 3)
    std::printf("%.17g\n", force(R1, R2, overlap, 0));
  RELEASECMINSTANCE(model);
}
