# Draws Figure 7 from the tables in figures/data, and checks the coefficients in them, as figure7.m does:
#
#   julia examples/scripts/figure7.jl fig07.svg
#
# with CSV, DataFrames and Plots. No Julia was at hand when this was written: it has been read, not run.
using CSV, DataFrames, Plots, Printf

data = joinpath(@__DIR__, "..", "figures", "data")
table(name) = CSV.read(joinpath(data, name * ".csv"), DataFrame)
curves, points, regions, coefficients = table.(["fig07_curves", "fig07_points", "fig07_regions", "coefficients"])
zeta = 0.02 # figures/parameters.toml
grazing(omega) = hypot(1 - omega^2, 2zeta * omega) # eq:Agraz

figure = plot(xlabel = "A", ylabel = "omega", xlims = (0, 1.3), ylims = (0.35, 1.02))
for (kind, grey) in ["non-impacting" => 0.91, "mps" => 0.7, "both" => 0.7, "undecided" => 0.5]
    for ring in groupby(regions[regions.kind .== kind, :], [:region, :ring])
        fill = Gray(max(grey, ring.ring[1] > 0)) # rings other than 0 are holes
        plot!(figure, Shape(ring.amplitude, ring.omega), color = fill, linewidth = 0, label = "")
    end
end
for (kind, colour) in ["graz" => :limegreen, "SN" => :blue, "PD" => :red, "GZ" => :darkgreen, "NS" => :purple]
    arcs = groupby(curves[(curves.kind .== kind) .& curves.admissible, :], :arc)
    for (k, arc) in enumerate(arcs)
        width = kind == "graz" ? 2.5 : 1
        plot!(figure, arc.amplitude, arc.omega, color = colour, linewidth = width, label = k == 1 ? kind : "")
    end
end
resonant = points.kind .== "resonance"
scatter!(figure, points.amplitude[resonant], points.omega[resonant], color = :black, marker = :utriangle, label = "resonance")
scatter!(figure, points.amplitude[.!resonant], points.omega[.!resonant], color = :black, markersize = 2, label = "codimension two")
savefig(figure, isempty(ARGS) ? "fig07.svg" : ARGS[1])

# At a resonance: the limit of (A - A_graz) / (omega - omega*)^2 on the curve that begins there, by a cubic in the impact velocity
# through the next four points.
function measured(kind, p, star)
    begins = (curves.kind .== kind) .& (curves.p .== p) .& (curves.impact_velocity .== 0) .& (abs.(curves.omega .- star) .< 1e-9)
    first = findfirst(begins)
    isnothing(first) && return NaN
    on = sort(findall(curves.arc .== curves.arc[first]), by = k -> abs(k - first))[2:5]
    quotient = (curves.amplitude[on] .- grazing.(curves.omega[on])) ./ (curves.omega[on] .- star) .^ 2
    return (curves.impact_velocity[on] .^ (0:3)' \ quotient)[1]
end

for row in eachrow(coefficients)
    @printf("%2d %2d  %.8f", row.p, row.n, row.omega_star)
    for (kind, column) in ["SN" => row.c_sn, "PD" => row.c_pd]
        @printf("  %-12.7g  %-12.7g", column, measured(kind, row.p, row.omega_star))
    end
    println()
end
