// An inspected pixel for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "viewer/inspection.h"

namespace sir::cli {

/// {"pixel":[column,row],"screen":[column,row]|null,"true":[r,g,b],"seen":[r,g,b],"index":..,
/// "code":[r,g,b],"de":..,"d2":..,"dithered":..,"nearest":{"bytes":[{..},{..}],"eye":[..]|null},
/// "why":{..},"group":{..},"ray":{..}|null}. An entry is {"index","seen","d2","de"}; "why" has
/// "method", and for the thesis's methods "cell", "plane", what became of them ("rank" and
/// "last_chosen", or "splits" and "box") and the "entry" made of the cell. "ray" is {"hit":false}
/// where it meets the background.
nlohmann::ordered_json inspection_json(const viewer::Inspection& inspection);

}  // namespace sir::cli
