// SPDX-License-Identifier: MIT
#define PY_SSIZE_T_CLEAN
#include "plugins/python/python_team.hpp"

#include "core/match/thought.hpp"
#include "mirocup/elementary.h"
#include "plugins/host/plugin.hpp"

#include <Python.h>
#include <algorithm>
#include <cstring>
#include <dlfcn.h>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mirocup::python {

namespace {

using match::Fault;
using match::FaultCode;

struct Release {
  void operator()(PyObject* object) const { Py_XDECREF(object); }
};
using Object = std::unique_ptr<PyObject, Release>;

struct PythonTeam {
  Object module;         // mirocup.team
  Object runner;         // a _Runner of it
  std::string name;      // of the file, in sentences
  std::string own_name;  // of the team, as its class says
  mirocup_strategy strategy{};
};

// Calls a function of a module or a method of an object. Null: an exception is set.
template <class... Arguments>
Object call(PyObject* owner, const char* function, const char* format, Arguments... arguments) {
  return Object(PyObject_CallMethod(owner, function, format, arguments...));
}

// Clears the exception that is set and returns it with a sentence; its traceback goes to the log.
Fault take_error(PyObject* module, const std::string& name, FaultCode code = FaultCode::crash) {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  const Object keep_type(type), error(value), keep_trace(trace);
  Fault fault{code, "an error without a text"};
  if (error == nullptr) return fault;
  if (trace != nullptr) PyException_SetTraceback(error.get(), trace);
  const Object told = module == nullptr
                          ? Object(Py_BuildValue("(Osi)", PyObject_Repr(error.get()), "", 0))
                          : call(module, "_describe", "Os", error.get(), name.c_str());
  const char* text = nullptr;
  const char* cause = nullptr;
  const bool is_told =
      told != nullptr && PyArg_ParseTuple(told.get(), "ssi", &text, &cause, &fault.line) != 0;
  fault.text = is_told ? text : "an error that cannot be told";
  if (is_told) fault.cause = cause;
  PyErr_Clear();
  return fault;
}

// ---- the functions of the setup, as `_host` of mirocup.team has them: `self` holds the setup

const mirocup_setup& setup_in(PyObject* self) {
  return *static_cast<const mirocup_setup*>(PyCapsule_GetPointer(self, nullptr));
}

// Reads a colour, 0xRRGGBBAA, as PyArg_ParseTuple() asks with "O&".
int read_colour(PyObject* number, void* colour) {
  const unsigned long value = PyLong_Check(number) != 0 ? PyLong_AsUnsignedLong(number) : ~0UL;
  PyErr_Clear();
  if (value > 0xffffffffUL) {
    PyErr_SetString(PyExc_ValueError, "a colour is a whole number, 0xRRGGBBAA");
    return 0;
  }
  *static_cast<std::uint32_t*>(colour) = static_cast<std::uint32_t>(value);
  return 1;
}

PyObject* host_parameter(PyObject* self, PyObject* arguments) {
  const char* name = nullptr;
  double fallback = 0.0;
  if (PyArg_ParseTuple(arguments, "sd", &name, &fallback) == 0) return nullptr;
  const mirocup_setup& setup = setup_in(self);
  return PyFloat_FromDouble(setup.parameter(setup.host, name, fallback));
}

// Draws a shape: its kind, layer, colour, the bytes of its numbers (match::Thought), and a text.
PyObject* host_draw(PyObject* self, PyObject* arguments) {
  int kind = 0;
  const char *layer = nullptr, *bytes = nullptr, *text = nullptr;
  std::uint32_t colour = 0;
  Py_ssize_t size = 0;
  if (PyArg_ParseTuple(arguments, "isO&y#s:draw", &kind, &layer, read_colour, &colour, &bytes,
                       &size, &text) == 0)
    return nullptr;
  const std::size_t count = static_cast<std::size_t>(size) / sizeof(double);
  std::vector<double> n(std::max<std::size_t>(count, 4));
  std::memcpy(n.data(), bytes, count * sizeof(double));
  const mirocup_setup& s = setup_in(self);
  switch (static_cast<match::ThoughtKind>(kind)) {
    case match::ThoughtKind::line:
      s.draw_line(s.host, layer, colour, n[0], n[1], n[2], n[3]);
      break;
    case match::ThoughtKind::circle:
      s.draw_circle(s.host, layer, colour, n[0], n[1], n[2]);
      break;
    case match::ThoughtKind::polygon:
      s.draw_polygon(s.host, layer, colour, n.data(), static_cast<std::int32_t>(count / 2));
      break;
    case match::ThoughtKind::text:
      s.draw_text(s.host, layer, colour, n[0], n[1], text);
  }
  Py_RETURN_NONE;
}

PyMethodDef host_methods[] = {{"parameter", host_parameter, METH_VARARGS, nullptr},
                              {"draw", host_draw, METH_VARARGS, nullptr}};

// ---- the functions of elementary.h, which mirocup.team has instead of those of math

template <double (*function)(double)>
PyObject* of_one(PyObject* /*self*/, PyObject* number) {
  const double x = PyFloat_AsDouble(number);
  return PyErr_Occurred() != nullptr ? nullptr : PyFloat_FromDouble(function(x));
}

template <double (*function)(double, double)>
PyObject* of_two(PyObject* /*self*/, PyObject* arguments) {
  double a = 0.0, b = 0.0;
  if (PyArg_ParseTuple(arguments, "dd", &a, &b) == 0) return nullptr;
  return PyFloat_FromDouble(function(a, b));
}

PyMethodDef elementary_functions[] = {{"sin", of_one<mirocup_sin>, METH_O, nullptr},
                                      {"cos", of_one<mirocup_cos>, METH_O, nullptr},
                                      {"tan", of_one<mirocup_tan>, METH_O, nullptr},
                                      {"asin", of_one<mirocup_asin>, METH_O, nullptr},
                                      {"acos", of_one<mirocup_acos>, METH_O, nullptr},
                                      {"atan", of_one<mirocup_atan>, METH_O, nullptr},
                                      {"atan2", of_two<mirocup_atan2>, METH_VARARGS, nullptr},
                                      {"hypot", of_two<mirocup_hypot>, METH_VARARGS, nullptr},
                                      {"exp", of_one<mirocup_exp>, METH_O, nullptr},
                                      {"log", of_one<mirocup_log>, METH_O, nullptr},
                                      {nullptr, nullptr, 0, nullptr}};

// ---- what an observation tells of each robot

// Python counts a negative index from the end, which is rarely meant of robots: the log says so.
PyObject* item_of_robots(PyObject* robots, PyObject* index) {
  if (PyLong_CheckExact(index) != 0 && PyLong_AsSsize_t(index) < 0) {
    PyErr_Clear();
    const Object told = call(PyImport_AddModule("mirocup.team"), "_warn_of_index", "O", index);
    if (told == nullptr) return nullptr;
  }
  return PyTuple_Type.tp_as_mapping->mp_subscript(robots, index);
}

// Returns the kind of tuple for `own` and `opponent`; null: an exception is set.
Object kind_of_robots() {
  PyType_Slot slots[] = {{Py_mp_subscript, reinterpret_cast<void*>(item_of_robots)}, {0, nullptr}};
  PyType_Spec spec{"mirocup.team._OfRobots", 0, 0, Py_TPFLAGS_DEFAULT, slots};
  const Object bases(PyTuple_Pack(1, &PyTuple_Type));
  return Object(bases == nullptr ? nullptr : PyType_FromSpecWithBases(&spec, bases.get()));
}

// Returns these functions by name, for this setup; null: an exception is set.
Object host_of(const mirocup_setup& setup) {
  const Object handle(PyCapsule_New(const_cast<mirocup_setup*>(&setup), nullptr, nullptr));
  Object functions(PyDict_New());
  if (handle == nullptr || functions == nullptr) return nullptr;
  for (PyMethodDef& method : host_methods) {
    const Object function(PyCFunction_New(&method, handle.get()));
    if (function == nullptr ||
        PyDict_SetItemString(functions.get(), method.ml_name, function.get()) != 0)
      return nullptr;
  }
  return functions;
}

// Lets a method of the team answer an observation and copies its bytes into `answer`.
template <class Answer>
void ask(void* handle, const char* method, const mirocup_observation& now, Answer& answer) {
  const auto& team = *static_cast<const PythonTeam*>(handle);
  const Object bytes = call(team.runner.get(), method, "y#", reinterpret_cast<const char*>(&now),
                            static_cast<Py_ssize_t>(sizeof now));
  if (bytes == nullptr) {
    const Fault raised = take_error(team.module.get(), team.name);
    throw plugins::RaisedError(raised.text, raised.cause, raised.line);
  }
  std::memcpy(&answer, PyBytes_AS_STRING(bytes.get()), sizeof answer);
}

void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  ask(team, "decide", *now, *command);
}

void place(void* team, const mirocup_observation* now, mirocup_placement* placement) {
  ask(team, "place", *now, *placement);
}

void destroy(void* team) {
  delete static_cast<PythonTeam*>(team);
}

constexpr mirocup_strategy functions{.abi_version = MIROCUP_ABI_VERSION,
                                     .size = sizeof(mirocup_strategy),
                                     .name = "",
                                     .create = nullptr,
                                     .decide = decide,
                                     .destroy = destroy,
                                     .place = place};

bool add_search_path(PyConfig& config, const char* path) {
  wchar_t* decoded = Py_DecodeLocale(path, nullptr);
  if (decoded == nullptr) return false;
  const PyStatus status = PyWideStringList_Append(&config.module_search_paths, decoded);
  PyMem_RawFree(decoded);
  return PyStatus_Exception(status) == 0;
}

// Returns false and `why` on failure. All folders are given, so that Python looks for none.
bool start_interpreter(Surrounding surrounding, std::string& why) {
  PyPreConfig before;
  PyPreConfig_InitIsolatedConfig(&before);
  before.utf8_mode = 1;
  PyStatus status = Py_PreInitialize(&before);
  PyConfig config;
  PyConfig_InitIsolatedConfig(&config);
  config.install_signal_handlers = surrounding == Surrounding::developer ? 1 : 0;
  config.site_import = 0;
  config.write_bytecode = 0;
  config.use_hash_seed = 1;  // of 0: the order of a set is the same in every leg
  config.module_search_paths_set = 1;
  bool is_set = PyStatus_Exception(status) == 0;
  for (const char* folder :
       {MIROCUP_PYTHON_LIBRARY, MIROCUP_PYTHON_LIBRARY "/lib-dynload",
        "/usr/local/lib/python3/dist-packages", "/usr/lib/python3/dist-packages"})
    is_set = is_set && add_search_path(config, folder);
  for (wchar_t** part : {&config.program_name, &config.executable, &config.base_executable})
    is_set =
        is_set && PyStatus_Exception(PyConfig_SetString(&config, part, L"/usr/bin/python3")) == 0;
  for (wchar_t** part :
       {&config.prefix, &config.exec_prefix, &config.base_prefix, &config.base_exec_prefix})
    is_set = is_set && PyStatus_Exception(PyConfig_SetString(&config, part, L"/usr")) == 0;
  if (is_set) status = Py_InitializeFromConfig(&config);
  if (!is_set || PyStatus_Exception(status) != 0) {
    why = status.err_msg != nullptr ? status.err_msg : "its configuration is not taken";
    PyConfig_Clear(&config);
    return false;
  }
  PyConfig_Clear(&config);
  return true;
}

// Makes the package mirocup with the module mirocup.team, from the text in this program.
Object make_module(Surrounding surrounding) {
  const Object package(PyImport_AddModule("mirocup"));
  PyObject* module = PyImport_AddModule("mirocup.team");
  Py_XINCREF(package.get());  // both are borrowed
  Py_XINCREF(module);
  Object team(module);
  if (package == nullptr || team == nullptr) return nullptr;
  if (PyModule_AddFunctions(module, elementary_functions) != 0) return nullptr;
  const Object of_robots = kind_of_robots();
  if (of_robots == nullptr || PyModule_AddObjectRef(module, "_OfRobots", of_robots.get()) != 0)
    return nullptr;
  const Object no_path(PyList_New(0));
  if (PyObject_SetAttrString(package.get(), "__path__", no_path.get()) != 0 ||
      PyObject_SetAttrString(package.get(), "team", module) != 0)
    return nullptr;
  // Where skills.h is for ctypes: in this program, or in the library that this code is part of.
  Dl_info here{};
  const bool is_library = surrounding == Surrounding::developer &&
                          dladdr(reinterpret_cast<const void*>(&start_interpreter), &here) != 0;
  const Object skills_in(is_library ? PyUnicode_DecodeFSDefault(here.dli_fname)
                                    : Py_BuildValue(""));
  if (skills_in == nullptr || PyModule_AddObjectRef(module, "_skills_in", skills_in.get()) != 0)
    return nullptr;
  const std::string source(team_source("team.py"));
  const Object code(Py_CompileString(source.c_str(), "mirocup/team.py", Py_file_input));
  PyObject* names = PyModule_GetDict(module);
  if (code == nullptr || PyDict_SetItemString(names, "__builtins__", PyEval_GetBuiltins()) != 0)
    return nullptr;
  const Object done(PyEval_EvalCode(code.get(), names, names));
  if (done == nullptr) return nullptr;
  const Object begun = call(module, "_begin", "i", surrounding == Surrounding::sandbox ? 1 : 0);
  return begun == nullptr ? nullptr : std::move(team);
}

// Returns the module, which is made once; null: an exception is set.
Object team_module(Surrounding surrounding) {
  PyObject* modules = PyImport_GetModuleDict();
  if (PyObject* known = PyDict_GetItemString(modules, "mirocup.team")) {
    Py_INCREF(known);
    return Object(known);
  }
  return make_module(surrounding);
}

}  // namespace

tl::expected<LoadedTeam, Fault> load_team(const std::string& text, const std::string& name,
                                          const mirocup_setup& setup, Surrounding surrounding) {
  const auto failed = [&name](PyObject* module, FaultCode code, const char* before) {
    Fault fault = take_error(module, name, code);
    fault.text.insert(0, before);
    return tl::unexpected<Fault>(std::move(fault));
  };
  std::string why;
  if (Py_IsInitialized() == 0 && !start_interpreter(surrounding, why))
    return tl::unexpected<Fault>(Fault{FaultCode::no_load, "Python does not start: " + why});
  auto team = std::make_unique<PythonTeam>();
  team->name = name;
  team->module = team_module(surrounding);
  PyObject* module = team->module.get();
  if (module == nullptr) return failed(nullptr, FaultCode::no_load, "Python does not start: ");
  const Object team_class =
      call(module, "_load", "y#s", text.data(), static_cast<Py_ssize_t>(text.size()), name.c_str());
  if (team_class == nullptr) return failed(module, FaultCode::no_load, "");
  const Object host = host_of(setup);
  if (host != nullptr) {
    team->runner =
        call(module, "_create", "Oy#O", team_class.get(), reinterpret_cast<const char*>(&setup),
             static_cast<Py_ssize_t>(sizeof setup), host.get());
  }
  if (team->runner == nullptr) return failed(module, FaultCode::crash, "__init__() raised ");
  const Object own_name(PyObject_GetAttrString(team_class.get(), "name"));
  const char* text_of_name = own_name != nullptr && PyUnicode_Check(own_name.get()) != 0
                                 ? PyUnicode_AsUTF8(own_name.get())
                                 : nullptr;
  PyErr_Clear();
  if (text_of_name != nullptr) team->own_name = text_of_name;
  team->strategy = functions;
  team->strategy.name = team->own_name.c_str();
  const mirocup_strategy* strategy = &team->strategy;
  return LoadedTeam{strategy, team.release()};
}

}  // namespace mirocup::python
