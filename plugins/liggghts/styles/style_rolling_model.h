#include "rolling_model_cdt.h"
#include "rolling_model_epsd.h"
#include "rolling_model_epsd2.h"
#include "rolling_model_epsd3.h"
