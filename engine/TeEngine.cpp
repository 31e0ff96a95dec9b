#include "engine/TeEngine.h"
