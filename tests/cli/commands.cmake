# The commands of README.md and the exit codes.
command_test(help CODE 0 OUT "problem write" ARGS --help)
command_test(version CODE 0 OUT "^jointid [0-9]+\\.[0-9]+\\.[0-9]+\n" ARGS --version)
command_test(nothing CODE 2 ERR "--help" ARGS)
command_test(misspelt CODE 2 ERR "did you mean 'solve'" ARGS sovle a.toml)

command_test(problem_list CODE 0 OUT "\nrig1 " ARGS problem list)
command_test(problem_write CODE 0 OUT "next: jointid solve" MAKES written ARGS problem write rig1 rig1 --format uff)
command_test(problem_unknown CODE 2 ERR "rig1" ARGS problem write rig_1 rig1)
command_test(problem_unwritable CODE 3 ERR "/dev/null" ARGS problem write A1 /dev/null/a1)

command_test(plan CODE 0 OUT "stiffness|K\\(1,1\\)" AFTER written ARGS plan rig1/rig1.toml)
command_test(plan_bound CODE 0 OUT "smallest standard errors.*without a coordinate.*with more data" AFTER study_data
  ARGS plan a1/A1.toml --bound --candidates 1:+Y)
command_test(plan_bound_json CODE 0 OUT "\"without_lines\":" AFTER study_data ARGS plan a1/A1.toml --bound --json -)
command_test(plan_candidate_unknown CODE 2 ERR "--candidates.*9:.Z" AFTER study_data ARGS plan a1/A1.toml --bound --candidates 9:+Z)
command_test(plan_candidates_alone CODE 2 ERR "--bound" AFTER study_data ARGS plan a1/A1.toml --candidates 1:+Y)
command_test(plan_json CODE 0 OUT "\"left_out\":" AFTER written ARGS plan rig1/rig1.toml --json -)
command_test(check CODE 0 OUT "^clean: " AFTER written ARGS check rig1/rig1.toml)
command_test(check_json CODE 0 OUT "^{\n  \"verdict\": \"clean\",\n  \"suspects\": " AFTER written
  ARGS check rig1/rig1.toml --json -)
command_test(check_absent CODE 2 ERR "absent.toml" ARGS check absent.toml)
command_test(solve CODE 0 OUT "against the truth" AFTER written ARGS solve rig1/rig1.toml)
command_test(solve_json CODE 0 OUT "^{\n  \"status\": \"ok\"" AFTER written ARGS solve rig1/rig1.toml --json -)
command_test(solve_both CODE 2 ERR "standard output" AFTER written ARGS solve rig1/rig1.toml --json - --csv -)
command_test(solve_absent CODE 2 ERR "absent.toml" ARGS solve absent.toml)
command_test(solve_report CODE 0 OUT "against the truth" AFTER written MAKES reported
  ARGS solve rig1/rig1.toml --plot 101:+Y/201:+Y --report rig1.html)
command_test(report_unwritable CODE 3 ERR "absent/a.html: cannot be written" AFTER written
  ARGS solve rig1/rig1.toml --report absent/a.html)
command_test(solve_unwritable CODE 3 ERR "absent/a.json: cannot be written" AFTER written
  ARGS solve rig1/rig1.toml --json absent/a.json)

command_test(correlate CODE 0 OUT "FRAC.*neither file states|FRAC.*degrees of freedom" AFTER study_data ARGS correlate a1/A1_substructure_1.h5 a1/A1_assembly.h5)
command_test(correlate_json CODE 0 OUT "\"fdac\": .*\"rows\": " AFTER study_data
  ARGS correlate a1/A1_substructure_1.h5 a1/A1_assembly.h5 --fdac 1:+Y --json -)
command_test(correlate_reference CODE 3 ERR "FDAC: 99:.Y is no reference of both" AFTER study_data
  ARGS correlate a1/A1_substructure_1.h5 a1/A1_assembly.h5 --fdac 99:+Y)
command_test(correlate_modes CODE 3 ERR "a1/A1_assembly.h5" AFTER study_data ARGS correlate a1/A1_assembly.h5 a1/A1_assembly.h5 --modes)
command_test(expand CODE 0 OUT "do not identify" AFTER study_data ARGS expand a1/A1_assembly.h5 a1/A1_substructure_1.h5 --out expanded.h5)
command_test(expand_modes CODE 2 ERR "--modes: .*no modes" AFTER study_data ARGS expand a1/A1_assembly.h5 a1/A1_substructure_1.h5 --modes 3)
command_test(expand_way CODE 2 ERR "--way" AFTER study_data ARGS expand a1/A1_assembly.h5 a1/A1_substructure_1.h5 --way sem)

command_test(info CODE 0 OUT "assembly.uff: UFF\n.*144 +58b.*accelerance" AFTER written ARGS info rig1/rig1_assembly.uff)
command_test(info_absent CODE 3 ERR "absent.uff: " ARGS info absent.uff)
command_test(info_other CODE 3 ERR "rig1.toml: " AFTER written ARGS info rig1/rig1.toml)
command_test(convert CODE 0 OUT "401 lines" AFTER written MAKES converted ARGS convert rig1/rig1_assembly.uff rig1.h5)
command_test(convert_back CODE 0 AFTER converted ARGS convert rig1.h5 rig1.csv)
command_test(convert_to_nothing CODE 2 ERR "xls" AFTER written ARGS convert rig1/rig1_assembly.uff rig1.xls)

command_test(study_clean CODE 0 MAKES study_data ARGS problem write A1 a1 --clean)
command_test(study CODE 0 OUT "median.*per second" AFTER study_data ARGS study a1/A1.toml --trials 20)
command_test(study_json CODE 0 OUT "\"rms_error\":" AFTER study_data
  ARGS study a1/A1.toml --trials 20 --json - --out study_json.h5)
command_test(study_report CODE 0 OUT "median.*per second" AFTER study_data MAKES study_reported
  ARGS study a1/A1.toml --trials 200 --report study.html --out study_report.h5)
command_test(study_report_stdout CODE 0 OUT "^<!DOCTYPE html>" AFTER study_data
  ARGS study a1/A1.toml --trials 20 --report - --out study_stdout.h5)
command_test(study_report_unwritable CODE 3 ERR "absent/a.html: cannot be written" AFTER study_data
  ARGS study a1/A1.toml --trials 1000000000 --report absent/a.html)
command_test(study_report_is_result CODE 2 ERR "both want the same file" AFTER study_data
  ARGS study a1/A1.toml --trials 1000000000 --report A1.study.h5)
command_test(study_no_trials CODE 2 ERR "--trials" AFTER study_data ARGS study a1/A1.toml --trials 0)

command_test(compare CODE 0 OUT "WBS .*Pareto" AFTER study_data
  ARGS compare a1/A1.toml --trials 3 --weightings WA,WBS --deltas 0,0.05)
command_test(compare_methods CODE 0 OUT "\"method\": \"two\"" AFTER study_data
  ARGS compare a1/A1.toml --trials 2 --methods one,two --json -)
command_test(compare_csv CODE 0 OUT "one,nn,WB,0,normal,stiffness," AFTER study_data
  ARGS compare a1/A1.toml --trials 2 --equations nn --weightings WB --solvers qr,normal --csv -)
command_test(compare_report CODE 0 OUT "WBS .*Pareto" AFTER study_data MAKES compare_reported
  ARGS compare a1/A1.toml --trials 3 --methods one,two --weightings WA,WBS --deltas 0,0.05 --report compare.html)
command_test(compare_report_unwritable CODE 3 ERR "absent/a.html: cannot be written" AFTER study_data
  ARGS compare a1/A1.toml --trials 1000000000 --report absent/a.html)
command_test(compare_list CODE 0 OUT "\n6.19 " ARGS compare --reproduce list)
command_test(compare_reproduce CODE 0 OUT "of 100 entries of the print" ARGS compare --reproduce 6.3 --trials 2)
command_test(compare_reproduce_report CODE 0 OUT "<title>Table 6.8.*✗.*doubtful print" ARGS compare --reproduce 6.8 --trials 2 --report -)
command_test(compare_no_table CODE 2 ERR "6.1.*`list`" ARGS compare --reproduce 6.1)
command_test(compare_nothing CODE 2 ERR "--reproduce" ARGS compare)
command_test(compare_weighting CODE 2 ERR "--weightings: 'WX'" AFTER study_data ARGS compare a1/A1.toml --weightings WX)
command_test(compare_solver CODE 2 ERR "solver" AFTER study_data ARGS compare a1/A1.toml --trials 2 --solvers magic)
command_test(compare_impossible CODE 2 ERR "nn" AFTER study_data ARGS compare a1/A1.toml --methods two --equations nn)

command_test(curve_write CODE 0 OUT "next: jointid loading-curve curve/table2.1-1.csv --law ren" MAKES curve
  ARGS problem write table2.1-1 curve)
command_test(curve_write_ring CODE 0 OUT "--law ren --ring 0.0255,0.038" MAKES ring_curve ARGS problem write table2.4-1 ring_curve)
command_test(pod CODE 0 OUT "of 2 channels, mean removed.*Σσ².*modes for 99 %" AFTER curve MAKES pod_read ARGS pod curve/table2.1-1.csv)
command_test(pod_json CODE 0 OUT "\"fractions_of_sigma_squared\"" AFTER curve ARGS pod curve/table2.1-1.csv --channels 2,1 --threads 2 --json -)
command_test(pod_csv CODE 0 OUT "^channel,unit,mean,mode 1,mode 2" AFTER curve ARGS pod curve/table2.1-1.csv --csv -)
command_test(pod_mass CODE 3 ERR "--mass needs a row for every channel" AFTER curve ARGS pod curve/table2.1-1.csv --mass curve/table2.1-1.csv)
command_test(pod_channel CODE 3 ERR "table2.1-1.csv" AFTER curve ARGS pod curve/table2.1-1.csv --channels absent)
command_test(pod_report CODE 0 OUT "^<!DOCTYPE html>" AFTER curve ARGS pod curve/table2.1-1.csv --report -)
command_test(pod_stiffness_alone CODE 2 ERR "give --mass" AFTER curve ARGS pod curve/table2.1-1.csv --stiffness curve/table2.1-1.csv)
command_test(pod_absent CODE 3 ERR "absent.csv" ARGS pod absent.csv)
command_test(loading_curve CODE 0 OUT "best by AIC: ren.*friction limit +10[67].*equivalent stiffness" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv)
command_test(loading_curve_json CODE 0 OUT "^{\n  \"status\": \"ok\".*\"best_law\": \"ren\"" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --law ren,shoukry --json -)
command_test(loading_curve_csv CODE 0 OUT "ren,table2.1-1,friction limit," AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --law ren --normal-load 490 --csv -)
command_test(loading_curve_preset CODE 0 OUT "friction limit +150 .*preset" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --law ren --limit 150)
command_test(loading_curve_pattern CODE 0 OUT "\"minimiser\": \"pattern\"" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --law shoukry --minimiser pattern --json -)
command_test(loading_curve_ring CODE 0 OUT "k +[0-9.e+]+ +N/m.3" AFTER ring_curve
  ARGS loading-curve ring_curve/table2.4-1.csv --law ren --ring 0.0255,0.038)
command_test(loading_curve_report CODE 0 OUT "best by AIC" AFTER curve MAKES loading_curve_reported
  ARGS loading-curve curve/table2.1-1.csv --report loading_curve.html)
command_test(loading_curve_law CODE 2 ERR "--law: 'renn' is no law.*did you mean ren" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --law renn)
command_test(loading_curve_no_file CODE 2 ERR "FILES" ARGS loading-curve)
command_test(loading_curve_absent CODE 3 ERR "absent.csv: there is no such file" ARGS loading-curve absent.csv)
command_test(loading_curve_column CODE 3 ERR "no column 'G'.*displacement, force" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --force G)
command_test(loading_curve_unit CODE 2 ERR "--unit: 'kg' is no unit" AFTER curve ARGS loading-curve curve/table2.1-1.csv --unit kg)
command_test(loading_curve_loops CODE 3 ERR "no whole cycle" AFTER curve ARGS loading-curve curve/table2.1-1.csv --kind loops)
command_test(loading_curve_loads CODE 2 ERR "--normal-load: 2 loads for 1 files" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --normal-load 1,2)
command_test(loading_curve_over_input CODE 2 ERR "would replace the input curve/table2.1-1.csv" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --json curve/table2.1-1.csv)
command_test(loading_curve_unwritable CODE 3 ERR "absent/a.html: cannot be written" AFTER curve
  ARGS loading-curve curve/table2.1-1.csv --report absent/a.html)
if(EXISTS "${JOINTID_EXTERNAL_DATA}/friction-loops/test_data_2.txt")
  set(_loops "${JOINTID_EXTERNAL_DATA}/friction-loops/test_data_2.txt")
  command_test(loading_curve_measured CODE 0 OUT "49 loops.*best by AIC: ren.*bilinear +39[0-9.]+ +40[0-9.]+ " MAKES measured_reported
    ARGS loading-curve "${_loops}" --law ren,bilinear --weighting travel --report measured.html)
else()
  jointid_missing(command.loading_curve_measured "${JOINTID_EXTERNAL_DATA}/friction-loops is missing: no external data")
endif()

command_test(couple_written CODE 0 OUT "next: jointid couple" MAKES couple_data ARGS problem write coupling-C c)
command_test(couple CODE 0 OUT "5:.Y = 7:.Y +0\\.[0-9 .]+left out.*wrote coupling-C.coupled.h5" AFTER couple_data
  ARGS couple c/coupling-C.toml)
command_test(couple_bounds CODE 0 OUT "with all conditions: " AFTER couple_data ARGS couple c/coupling-C.toml --bounds --out bounds.h5)
command_test(couple_json CODE 0 OUT "\"left_out\": true" AFTER couple_data ARGS couple c/coupling-C.toml --out couple_json.h5 --json -)
command_test(couple_csv CODE 0 OUT "^frequency_hz,condition,kept,usable,alpha_1,alpha_2,alpha_3\n5," AFTER couple_data
  ARGS couple c/coupling-C.toml --out couple_csv.h5 --csv -)
command_test(couple_report CODE 0 OUT "with all conditions: " AFTER couple_data MAKES couple_reported
  ARGS couple c/coupling-C.toml --bounds --out couple_report.h5 --report couple.html)
command_test(couple_report_stdout CODE 0 OUT "^<!DOCTYPE html>.*5:.Y = 7:.Y.*2 of 5 conditions are left out" AFTER couple_data
  ARGS couple c/coupling-C.toml --out couple_stdout.h5 --report -)
command_test(couple_report_unwritable CODE 3 ERR "absent/a.html: cannot be written" AFTER couple_data
  ARGS couple c/coupling-C.toml --out couple_absent.h5 --report absent/a.html)
command_test(couple_onto_part CODE 2 ERR "would replace the input c/coupling-C_part_1.h5" AFTER couple_data
  ARGS couple c/coupling-C.toml --out c/coupling-C_part_1.h5)
command_test(couple_unwritable CODE 3 ERR "absent/a.h5: cannot be written" AFTER couple_data
  ARGS couple c/coupling-C.toml --out absent/a.h5)
command_test(rig2_written CODE 0 OUT "next: jointid equivalent" MAKES rig2_data ARGS problem write rig2 rig2)
command_test(equivalent CODE 0 OUT "by \\(7\\.18\\), FRFs of the parts made real.*4e-07 +[67][0-9.e+]+ " AFTER rig2_data
  ARGS equivalent rig2/rig2.toml)
command_test(equivalent_csv CODE 0 AFTER rig2_data MAKES rig2_csv ARGS equivalent rig2/rig2.toml --csv rig2.csv)
command_test(equivalent_json CODE 0 OUT "\"equation\": \"7.18\"" AFTER rig2_data ARGS equivalent rig2/rig2.toml --json -)
command_test(equivalent_fitted CODE 0 OUT "friction limit +1[3-5]\\.[0-9]+ +N" AFTER rig2_csv
  ARGS loading-curve rig2.csv --stiffness stiffness --damping damping --law ren)
set(_fold "${CMAKE_CURRENT_SOURCE_DIR}/response/fold.toml")
command_test(response CODE 0 OUT "0\\.45 +0\\.339596 +7\\.69047.*turns back at 0\\.339608 Hz" ARGS response ${_fold})
command_test(response_json CODE 0 OUT "^{\n  \"status\": \"ok\"" ARGS response ${_fold} --json -)
command_test(response_csv CODE 0 OUT "^force .N.,frequency .Hz.,harmonic,dof,re .m.,im .m.,std dev re .m.,std dev im .m.,left out .m.\n0.2,0.08," ARGS response ${_fold} --csv -)
command_test(beams_written CODE 0 OUT "next: jointid response" MAKES beams ARGS problem write beams-B beams)
command_test(response_beams CODE 0 OUT " 1 +50 +1\\.7125e-06 +166\\.26 .* 100 +50 +0\\.000295648 " AFTER beams ARGS response beams/beams-B.toml)
command_test(response_compare_nothing CODE 2 ERR "--compare.*there is no case" ARGS response ${_fold} --compare)
command_test(response_history_nothing CODE 2 ERR "--history.*the scene has no .transient." ARGS response ${_fold} --history -)
command_test(pulse_written CODE 0 OUT "next: jointid response" MAKES pulse ARGS problem write pulse-ren pulse)
command_test(response_pulse CODE 0 OUT "pulse of 36 N, 0.165347 s +2.64555 .* 57" AFTER pulse ARGS response pulse/pulse-ren.toml)
command_test(oscillation_written CODE 0 OUT "next: jointid oscillate" MAKES oscillation ARGS problem write chain-10-orbit chain)
command_test(oscillate CODE 0 OUT "period 126.774673206 .*stable.*craig_bampton +3 " AFTER oscillation MAKES oscillated ARGS oscillate chain/chain-10-orbit.toml --csv chain.csv)
command_test(oscillate_json CODE 0 OUT "^{\n  \"status\": \"ok\"" AFTER oscillation ARGS oscillate chain/chain-10-orbit.toml --json -)
command_test(oscillate_report CODE 0 OUT "^<!DOCTYPE html>" AFTER oscillation ARGS oscillate chain/chain-10-orbit.toml --report -)
command_test(oscillate_no_sweep CODE 2 ERR "has no .sweep." AFTER oscillation ARGS oscillate chain/chain-10-orbit.toml --sweep -)
command_test(oscillate_absent CODE 2 ERR "absent.toml" ARGS oscillate absent.toml)
command_test(pod_of_oscillation CODE 0 OUT "5000 samples of 10 channels" AFTER oscillated ARGS pod chain.csv --channels q1,q2,q3,q4,q5,q6,q7,q8,q9,q10)
command_test(series_delay CODE 0 OUT "Theiler window.*largest exponent, Kantz" AFTER oscillated ARGS series delay chain.csv --channel q1 --samples 2000 --most-dimension 4)
command_test(series_friction CODE 0 OUT "μ_K +0.3 ±.*α s/m +2 ±" AFTER oscillated
  ARGS series friction chain.csv --velocity "relative velocity" --force friction --normal normal --stick-speed 1e-9)
command_test(series_align CODE 0 OUT "against q1" AFTER oscillated ARGS series align chain.csv --reference q1 --frequency 0.0631)
command_test(series_strain CODE 0 OUT "2 gauges, 2 shapes, condition" AFTER oscillated
  ARGS series strain chain.csv --channels q1,q2 --length 0.4 --thickness 0.001 --gauges 0.05,0.1)
command_test(series_strain_gauges CODE 3 ERR "channels for 1 gauges" AFTER oscillated
  ARGS series strain chain.csv --length 0.4 --thickness 0.001 --gauges 0.05)
command_test(series_reversal CODE 3 ERR "are one column; name every column once" AFTER oscillated ARGS series reversal chain.csv --displacement q1 --force q1 --slip-force 1e9 --share 0.05)
command_test(series_absent CODE 3 ERR "absent.csv" ARGS series delay absent.csv)
command_test(series_nothing CODE 2 ERR "--help" ARGS series)
command_test(response_absent CODE 2 ERR "absent.toml" ARGS response absent.toml)
command_test(response_unwritable CODE 3 ERR "absent/a.csv: cannot be written" ARGS response ${_fold} --csv absent/a.csv)
command_test(equivalent_absent CODE 2 ERR "absent.toml" ARGS equivalent absent.toml)
command_test(equivalent_other_scene CODE 2 ERR "equivalent" AFTER couple_data ARGS equivalent c/coupling-C.toml)
command_test(equivalent_unwritable CODE 3 ERR "absent/a.csv: cannot be written" AFTER rig2_data ARGS equivalent rig2/rig2.toml --csv absent/a.csv)
command_test(couple_absent CODE 2 ERR "absent.toml" ARGS couple absent.toml)
command_test(couple_other_scene CODE 2 ERR "couple" AFTER study_data ARGS couple a1/A1.toml)

# Time records: the commands of docs/records.md.
if(EXISTS "${JOINTID_EXTERNAL_DATA}/hammer-repeats")
  set(_hits "${JOINTID_EXTERNAL_DATA}/hammer-repeats/measurements")
  command_test(frf CODE 0 OUT "1:\\+Z +5 +5 +5.*12801 lines.*wrote hits.h5: accelerance with variances" MAKES hits
    ARGS frf ${_hits}_1.npy ${_hits}_2.npy ${_hits}_3.npy ${_hits}_4.npy ${_hits}_5.npy --channel "2=1:+Z N" --channel "3=4:+Z m/s^2" --time 1
      --output hits.h5 --report hits.html)
  command_test(frf_info CODE 0 OUT "12801, 0 to 12800 Hz" AFTER hits ARGS info hits.h5)
  command_test(frf_shaker CODE 0 OUT "7 +7 +6\\.682" ARGS frf ${JOINTID_EXTERNAL_DATA}/siso-coherence/case1.mat --shaker --block 0.8 --rate 1280
    --remove-mean --channel "Time_chan_1=1:+Z N" --channel "Time_chan_2=1:+Z m/s^2")
else()
  jointid_missing(command.frf "${JOINTID_EXTERNAL_DATA}/hammer-repeats is missing: no external data")
endif()

# Modal models.
command_test(modal_set CODE 0 OUT "next: jointid modalfit" MAKES modal_data ARGS problem write modes-pair pair --format h5)
command_test(modalfit CODE 0 OUT "101\\.000.*fit of each FRF: +0\\.0.*symmetric model: +0\\.0" AFTER modal_data
  ARGS modalfit pair/modes-pair.h5 --real --damping hysteretic)
command_test(modalfit_json CODE 0 OUT "^{\n  \"status\": \"ok\".*\"stabilisation\": " AFTER modal_data
  ARGS modalfit pair/modes-pair.h5 --range 95:105 --modes 2 --json -)
command_test(modalfit_files CODE 0 OUT "4 × 2 FRFs" MAKES modal_files AFTER modal_data
  ARGS modalfit pair/modes-pair.h5 --real --damping hysteretic --regenerate pair_all.h5 --shapes pair_shapes.uff --csv pair.csv --report pair.html)
command_test(modalfit_regenerated CODE 0 OUT "responses +4: .*references +4: .*not measured +none" AFTER modal_files ARGS info pair_all.h5)
command_test(modalfit_empty_range CODE 3 ERR "range: 0 lines are in it" AFTER modal_data ARGS modalfit pair/modes-pair.h5 --range 200:300)
command_test(modalfit_wrong_range CODE 2 ERR "--range: '95' is not LOW:HIGH" AFTER modal_data ARGS modalfit pair/modes-pair.h5 --range 95)
command_test(modalfit_wrong_damping CODE 2 ERR "did you mean hysteretic" AFTER modal_data ARGS modalfit pair/modes-pair.h5 --damping histeretic)
command_test(modalfit_no_modes CODE 4 ERR "No mode exceeds the noise" AFTER modal_data ARGS modalfit pair/modes-pair.h5 --range 104:110)
command_test(modalfit_absent CODE 3 ERR "absent.h5" ARGS modalfit absent.h5)
command_test(compare_regenerated CODE 0 OUT "one, regenerated substructures" AFTER study_data
  ARGS compare a1/A1.toml --regenerate none,substructures --trials 2)
command_test(compare_regenerated_wrong CODE 2 ERR "--regenerate.*did you mean substructures" AFTER study_data
  ARGS compare a1/A1.toml --regenerate substructure --trials 2)

# Digits of every solver.
command_test(stability SLOW CODE 0 OUT "stiffness: .*condition +normal +qr +svd +spqr +two +direct +newton +likelihood.*random scenes +6 .* 0 +[0-9]+\n" MAKES stability_reported
  ARGS stability --sweeps stiffness,laeuchli --scenes 6 --report stability.html)
command_test(stability_json CODE 0 OUT "\"digits_kept\": " ARGS stability --sweeps laeuchli --scenes 0 --json -)
command_test(stability_csv CODE 0 OUT "^sweep,value,method,solver,.*\nlaeuchli,1,rows,spqr," ARGS stability --sweeps laeuchli --scenes 0 --csv -)
command_test(stability_unknown CODE 2 ERR "--sweeps: 'stifness' is no sweep.*did you mean 'stiffness'" ARGS stability --sweeps stifness)
command_test(stability_unwritable CODE 3 ERR "absent/a.html: cannot be written" ARGS stability --report absent/a.html)
command_test(laws_written CODE 0 OUT "next: jointid solve" MAKES law_files ARGS problem write sdof-iwan law_files)
command_test(laws_solved SLOW CODE 0 OUT "law: iwan.*initial stiffness.*friction limit.*status: ok" AFTER law_files ARGS solve law_files/sdof-iwan.toml)
command_test(laws_equivalent CODE 0 OUT "joint: stiffness and damping without a law.*status: ok" AFTER law_files ARGS equivalent law_files/sdof-iwan.toml)
command_test(laws_equivalent_page CODE 0 AFTER law_files ARGS equivalent law_files/sdof-iwan.toml --report laws_equivalent.html)
command_test(laws_equivalent_csv CODE 0 OUT "joint,level,frequency .Hz." AFTER law_files ARGS equivalent law_files/sdof-iwan.toml --csv -)
command_test(laws_compared CODE 0 OUT "2 trials; laws found from the measured levels, known to both ways: iwan.*two steps: answers in 2 of 2.*friction limit" AFTER law_files
  ARGS compare law_files/sdof-iwan.toml --trials 2)
command_test(laws_compared_json CODE 0 OUT "\"name\": \"two_steps\".*\"rms_error\"" AFTER law_files ARGS compare law_files/sdof-iwan.toml --trials 2 --json -)
command_test(laws_compared_page CODE 0 AFTER law_files ARGS compare law_files/sdof-iwan.toml --trials 2 --report laws_compared.html)
command_test(laws_compared_over_input CODE 2 ERR "sdof-iwan_part_1.h5" AFTER law_files
  ARGS compare law_files/sdof-iwan.toml --trials 2 --json law_files/sdof-iwan_part_1.h5)
command_test(laws_compared_by_methods CODE 2 ERR "--methods: the scene is one of friction laws" AFTER law_files
  ARGS compare law_files/sdof-iwan.toml --methods one)
command_test(laws_plot CODE 2 ERR "there is no FRF of an assembly" AFTER law_files ARGS solve law_files/sdof-iwan.toml --plot 1:+Y/1:+Y)

command_test(flange_written CODE 0 OUT "next: jointid solve" MAKES flange_files ARGS problem write flange-turned flange)
command_test(flange_checked CODE 0 OUT "direction .*13:\\+Y.*correction:.*directions = .*consistency of virtual points.*12 sensors" AFTER flange_files
  ARGS check flange/flange-turned.toml)
command_test(flange_checked_json CODE 0 OUT "\"rigidity\"" AFTER flange_files ARGS check flange/flange-turned.toml --json -)

command_test(export CODE 0 OUT "wrote bracket.bdf\nwrote bracket_covariance.csv" AFTER study_data
  ARGS export a1/A1.toml --to nastran --out bracket)
command_test(export_program CODE 2 ERR "--to: .*nastran" AFTER study_data ARGS export a1/A1.toml --to nastrn)
command_test(export_way CODE 2 ERR "no bush for ansys.*--as springs" AFTER study_data ARGS export a1/A1.toml --to ansys --as bush)
command_test(export_band CODE 2 ERR "--band.*leave it out" AFTER study_data ARGS export a1/A1.toml --to ansys --band 3)
