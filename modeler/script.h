// Scripts: commands, one a line. They are the source of a scene, as the .CSG is what becomes of it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "modeler/interpreter.h"
#include "tracer/text_file.h"

namespace sir::modeler {

/// Does the lines of one script, each as it comes.
class Script {
 public:
  /// `name` stands for the script in errors; `hear` gets every reply.
  Script(Interpreter& interpreter, std::string name, std::function<void(const Reply& reply)> hear);

  /// A line, in UTF-8. False after quit. Throws FileError "name:line: reason"
  /// for a command that cannot be done.
  bool line(std::string_view text, std::size_t number);

 private:
  Interpreter& interpreter_;
  std::string name_;
  std::function<void(const Reply&)> hear_;
};

/// Does a whole script, up to its end or a quit. Throws as above; what came before the error stays
/// done.
void run_script(TextFile& file, Interpreter& interpreter,
                const std::function<void(const Reply& reply)>& hear);

}  // namespace sir::modeler
