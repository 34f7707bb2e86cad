# The shared library of kinestat called from Julia: a report, and a case played for many states. It
# needs no package. The library is the one that the system finds, or what the environment variable
# KINESTAT_LIBRARY names; kinestat.h describes the functions.
#
#   julia julia_report.jl

const LIBRARY = get(ENV, "KINESTAT_LIBRARY", "libkinestat.so.0")

# Stops with what the program would print. A report with status 1 (a published value is missed) or
# 5 (a case has no answer) is there all the same: whoever wants it allows these.
function check(status)
    status == 0 && return
    text = unsafe_string(ccall((:kinestat_message_text, LIBRARY), Cstring, ()))
    error("kinestat, status $status\n$text")
end

file = joinpath(@__DIR__, "..", "..", "mechanisms", "transmissions", "ravigneaux.yaml")

mechanism = Ref{Ptr{Cvoid}}(C_NULL)
check(ccall((:kinestat_read_file, LIBRARY), Cint, (Cstring, Ref{Ptr{Cvoid}}), file, mechanism))

# A report, and a number at a place of it
report = Ref{Ptr{Cvoid}}(C_NULL)
check(ccall((:kinestat_analyze, LIBRARY), Cint, (Ptr{Cvoid}, Ref{Ptr{Cvoid}}), mechanism[], report))
for case in ["M1", "M2", "M3", "MR"]
    number = Ref{Cdouble}(NaN)
    check(ccall((:kinestat_number, LIBRARY), Cint, (Ptr{Cvoid}, Cstring, Ref{Cdouble}),
                report[], "/cases/$case/ratio", number))
    println(case, ": ratio ", round(number[]; digits = 4))
end
ccall((:kinestat_free_report, LIBRARY), Cvoid, (Ptr{Cvoid},), report[])

# The ring and the long planet follow from the other teeth from now on.
for (name, value) in ["N3" => "N2 + 2*N6jk", "N6i" => "N2 + N6jk - N1 - 2*N5"]
    check(ccall((:kinestat_set, LIBRARY), Cint, (Ptr{Cvoid}, Cstring, Cstring),
                mechanism[], name, value))
end

# Case M1 for many teeth. A column is a state, as Julia stores matrices by columns.
inputs = ["N1", "N2", "N5"]
outputs = ["ratio", "out"]
tape = Ref{Ptr{Cvoid}}(C_NULL)
check(ccall((:kinestat_record, LIBRARY), Cint,
            (Ptr{Cvoid}, Cstring, Ptr{Ptr{UInt8}}, Csize_t, Ptr{Ptr{UInt8}}, Csize_t, Ref{Ptr{Cvoid}}),
            mechanism[], "M1", inputs, length(inputs), outputs, length(outputs), tape))
ccall((:kinestat_free_mechanism, LIBRARY), Cvoid, (Ptr{Cvoid},), mechanism[])

states = [Float64(n) for n in 1:3, _ in 1:20]
states[1, :] .= 16:35
states[2, :] .= 41
states[3, :] .= 15
answers = fill(NaN, length(outputs), size(states, 2))
words = fill(Ptr{UInt8}(C_NULL), size(states, 2))
check(ccall((:kinestat_play, LIBRARY), Cint,
            (Ptr{Cvoid}, Ptr{Cdouble}, Csize_t, Ptr{Cdouble}, Ptr{Ptr{UInt8}}),
            tape[], states, size(states, 2), answers, words))
solved = unsafe_string.(words) .== "solved"  # these texts live as long as the tape
ccall((:kinestat_free_tape, LIBRARY), Cvoid, (Ptr{Cvoid},), tape[])

println(count(solved), " of ", size(states, 2), " states are solved")
for state in findall(solved)
    println("N1 = ", Int(states[1, state]), ": ratio ", round(answers[1, state]; digits = 4),
            ", torque of the ring ", round(answers[2, state]; digits = 1), " N*m")
end
