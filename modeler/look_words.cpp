#include "modeler/look_words.h"

namespace sir::modeler {
namespace {

constexpr Word<CameraWord> kCamera[] = {{"window", "janela", CameraWord::window},
                                        {"target", "alvo", CameraWord::target},
                                        {"normal", "normal", CameraWord::normal},
                                        {"distance", "distância", CameraWord::distance},
                                        {"up", "acima", CameraWord::up},
                                        {"focal", "focal", CameraWord::focal},
                                        {"parallel", "paralela", CameraWord::parallel},
                                        {"perspective", "perspectiva", CameraWord::perspective},
                                        {"load", "carrega", CameraWord::load},
                                        {"save", "salva", CameraWord::save},
                                        {"frame", "enquadra", CameraWord::frame},
                                        {"turn", "gira", CameraWord::turn},
                                        {"pan", "desloca", CameraWord::pan},
                                        {"zoom", "amplia", CameraWord::zoom},
                                        {"auto", "automática", CameraWord::made_up}};

constexpr Word<LightWord> kLight[] = {{"background", "fundo", LightWord::background},
                                      {"ambient", "ambiente", LightWord::ambient},
                                      {"add", "acrescenta", LightWord::add},
                                      {"move", "move", LightWord::move},
                                      {"colour", "cor", LightWord::colour},
                                      {"delete", "deleta", LightWord::erase},
                                      {"set", "define", LightWord::set},
                                      {"load", "carrega", LightWord::load},
                                      {"save", "salva", LightWord::save},
                                      {"auto", "automática", LightWord::made_up}};

constexpr Word<SurfacesWord> kSurfaces[] = {{"load", "carrega", SurfacesWord::load},
                                            {"save", "salva", SurfacesWord::save},
                                            {"delete", "deleta", SurfacesWord::erase}};

constexpr Word<SurfaceWord> kSurface[] = {
    {"name", "nome", SurfaceWord::name},
    {"colour", "cor", SurfaceWord::colour},
    {"ambient", "ambiente", SurfaceWord::ambient},
    {"diffuse", "difusa", SurfaceWord::diffuse},
    {"specular", "especular", SurfaceWord::specular},
    {"exponent", "expoente", SurfaceWord::exponent},
    {"transmission", "transmissão", SurfaceWord::transmission},
    {"index", "índice", SurfaceWord::index},
    {"plain", "lisa", SurfaceWord::plain},
    {"chequer", "xadrez", SurfaceWord::chequer},
    {"odd", "ímpar", SurfaceWord::odd},
    {"even", "par", SurfaceWord::even}};

constexpr Word<bool ViewSettings::*> kView[] = {
    {"ghosts", "fantasmas", &ViewSettings::ghosts},
    {"axes", "eixos", &ViewSettings::axes},
    {"bounds", "envoltórios", &ViewSettings::bounds},
    {"grid", "grade", &ViewSettings::grid},
    {"silhouette", "silhueta", &ViewSettings::silhouette},
    {"alone", "sozinho", &ViewSettings::alone}};

constexpr Word<bool> kSwitch[] = {{"on", "sim", true}, {"off", "não", false}};

constexpr Word<ScriptWord> kScript[] = {{"load", "carrega", ScriptWord::load},
                                        {"save", "salva", ScriptWord::save}};

}  // namespace

std::span<const Word<CameraWord>> camera_words() { return kCamera; }
std::span<const Word<LightWord>> light_words() { return kLight; }
std::span<const Word<SurfacesWord>> surfaces_words() { return kSurfaces; }
std::span<const Word<SurfaceWord>> surface_words() { return kSurface; }
std::span<const Word<bool ViewSettings::*>> view_words() { return kView; }
std::span<const Word<bool>> switch_words() { return kSwitch; }
std::span<const Word<ScriptWord>> script_words() { return kScript; }

}  // namespace sir::modeler
