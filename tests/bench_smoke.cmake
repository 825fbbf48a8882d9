# That the benchmark programs run and find what they compare equal: a round or so of each, on little.
# How fast is another matter. ctest --preset smoke
# bench_smoke(PROGRAM [ARGUMENT ...])
function(bench_smoke program)
  add_test(NAME bench_smoke.${program} CONFIGURATIONS smoke
    COMMAND ${program} ${ARGN} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(bench_smoke.${program} PROPERTIES
    LABELS bench TIMEOUT 300 ENVIRONMENT "SIR_BENCH_ROUNDS=1;SDL_VIDEODRIVER=dummy")
endfunction()

bench_smoke(claim_bench)
bench_smoke(cost_bench 30 50)
bench_smoke(display_bench)
bench_smoke(effects_bench images/lcg)
bench_smoke(engine_bench 30)
bench_smoke(model_window_bench)
bench_smoke(modeler_bench 1000)
bench_smoke(nearest_bench)
bench_smoke(packet_bench 64)
bench_smoke(part_bench --benchmark_min_time=0.001)
bench_smoke(peer_bench $<TARGET_FILE:sir>)
bench_smoke(peers --rounds 1 --parts memory,orbit --frames 2)
bench_smoke(preview_bench)
bench_smoke(quant_bench)
bench_smoke(quantizers $<TARGET_FILE:sir> docs/pictures --rounds 1 --only calice)
bench_smoke(robust_bench)
bench_smoke(sample_bench images/lcg 40x30)
bench_smoke(workshop_bench images/lcg)
