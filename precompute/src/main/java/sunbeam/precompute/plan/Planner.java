package sunbeam.precompute.plan;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Sampling.BinSampling;
import sunbeam.precompute.plan.Sampling.OrderSampling;
import sunbeam.precompute.plan.Sampling.OrderSampling.BandRule;
import sunbeam.precompute.reference.ExactLight.WindowLight;
import sunbeam.precompute.setting.Excess;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.spectrum.Expansion;
import sunbeam.precompute.spectrum.Expansion.TaylorExpansion;
import sunbeam.precompute.spectrum.HeightScale;
import sunbeam.precompute.spectrum.InterpolationDesign;
import sunbeam.precompute.spectrum.LowRankExpansion;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Makes a {@link SpectrumPlan} from a patch, the user's choices and a scene's directions, within a heap of so many bytes and a shader's
 * loop steps per pixel.
 */
public record Planner(HeightMap heights, CieTable cie, long heapLimit, long mostSteps, Roughness.Cache statistics) {
    private static final int THESIS_TERMS = 37;
    // Per coherence length. A Gaussian of deviation s sampled at a pitch p has replicas of its spectrum at distance 1 /
    // p; the first adds exp(-2 pi^2 s^2 / p^2), 3e-9 at s = p, to a coherent power's normalization.
    private static final double FEWEST_SAMPLES = 4;
    // Meters: the first order of a period of two samples is then 3 degrees from the mirror direction at 550 nm.
    private static final double COARSEST_PITCH = 5e-6;
    // Radians; the time to find an expansion's basis, half a minute here, grows with the third power.
    private static final double LARGEST_PHASE = 800;

    public Planner(HeightMap heights, CieTable cie, Roughness.Cache statistics) {
        this(heights, cie, Runtime.getRuntime().maxMemory(), Sampling.MOST_LOOP_STEPS, statistics);
    }

    /** Color tables of the ensemble average are summed on the CPU, without a shader's limit on loops. */
    public Planner ofTables(Average average) {
        return average == Average.ENSEMBLE ? new Planner(heights, cie, heapLimit, Long.MAX_VALUE, statistics) : this;
    }

    /** Returns the fastest plan that keeps the tolerance and fits into memory; throws SettingException if there is none. */
    public SpectrumPlan plan(TableChoices choices, GaussianArea area, VisibleRange range) {
        return plan(choices, area, range, roughness(choices, area, range));
    }

    /** Plans for a patch whose roughness, which takes seconds, was measured under this window or a longer one. */
    public SpectrumPlan plan(TableChoices choices, GaussianArea area, VisibleRange range, Roughness roughness) {
        HeightMap map = heights;
        requireSamples(area.window(), map);
        ErrorBudget budget = new ErrorBudget(choices.tolerance(), roughness.withWindow(area.window(), range));
        Expansion expansion = expansion(choices, range, budget);
        List<Supplier<Sampling>> samplings = choices.fixesBins()
                ? List.of(() -> BinSampling.of(choices, area.window(), map, cie))
                : new Samplings(heights, cie, area, range, budget).choices();
        Optional<SettingException> refusal = Optional.empty();
        for (Supplier<Sampling> choice : samplings) {
            Sampling sampling = choice.get();
            // One bin more, since float32 may round to the next.
            Neighborhood around = sampling.neighborhood();
            SpectrumPlan plan = new SpectrumPlan(
                    choices.choices().find(MethodSettings.TOLERANCE),
                    range,
                    expansion,
                    range.bandX(map.width(), around.radiusX() + 1),
                    range.bandY(map.height(), around.radiusY() + 1),
                    area,
                    sampling);
            refusal = plan.refusal(map.rows(), heapLimit, mostSteps);
            if (refusal.isEmpty()) {
                return plan;
            }
        }
        throw refusal.orElseThrow();
    }

    /** Measures the roughness if the plan may interpolate the spectrum on a grid; else returns {@link Roughness#NONE}. */
    public Roughness roughness(TableChoices choices, GaussianArea area, VisibleRange range) {
        return !choices.fixesBins() && Samplings.interpolates(heights, area.window())
                ? Roughness.measure(heights, area.window(), area.origin(), range, statistics)
                : Roughness.NONE;
    }

    /** Returns which limit a need of memory exceeds; empty if it fits. */
    public Optional<Excess> excess(MemoryNeed need) {
        return need.excess(heapLimit);
    }

    public Expansion expansion(TableChoices table, VisibleRange range) {
        return expansion(table, range, new ErrorBudget(table.tolerance()));
    }

    private Expansion expansion(TableChoices table, VisibleRange range, ErrorBudget budget) {
        boolean thesis = table.isThesis();
        Optional<Integer> chosen = table.choices().find(MethodSettings.TERMS);
        Expansion.Kind kind =
                table.choices().get(MethodSettings.EXPANSION, thesis ? Expansion.Kind.TAYLOR : Expansion.Kind.LOWRANK);
        HeightScale scale = thesis ? HeightScale.mean(heights) : HeightScale.midRange(heights);
        double minimum = scale.phase(CieTable.MAXIMUM_WAVELENGTH, range.minimumW());
        double maximum = scale.phase(CieTable.MINIMUM_WAVELENGTH, range.maximumW());
        Optional<Integer> terms = thesis ? Optional.of(chosen.orElse(THESIS_TERMS)) : chosen;
        double tolerance = terms.isPresent() ? -1 : budget.expansion();
        if (kind == Expansion.Kind.LOWRANK) {
            requireExpandable(scale, maximum);
            return LowRankExpansion.of(heights, scale, minimum, maximum, tolerance, terms.orElse(Integer.MAX_VALUE));
        }
        TaylorExpansion taylor = terms.isPresent()
                ? new TaylorExpansion(scale, terms.get(), maximum)
                : TaylorExpansion.within(scale, maximum, tolerance);
        return requireFloats(taylor, terms.isPresent(), budget.tolerance());
    }

    private static void requireExpandable(HeightScale scale, double maximumPhase) {
        if (maximumPhase > LARGEST_PHASE) {
            throw SettingException.of(
                    MethodSettings.EXPANSION,
                    Expansion.Kind.LOWRANK,
                    Text.format(
                            "does not reach over a relief of %s, whose phases are up to %.0f rad, more than %.0f; method"
                                    + " reference, for lists, takes any relief; else crop the patch",
                            Lengths.format(2 * scale.halfRange()), maximumPhase, LARGEST_PHASE));
        }
    }

    private static void requireSamples(CoherenceWindow window, HeightMap map) {
        double pitch = Math.max(map.columns() > 1 ? map.pitchX() : 0, map.rows() > 1 ? map.pitchY() : 0);
        double coherenceLength = window.coherenceLength();
        if (coherenceLength < FEWEST_SAMPLES * pitch) {
            throw SettingException.of(
                    MethodSettings.COHERENCE_LENGTH,
                    coherenceLength,
                    Text.format(
                            "is less than %.0f samples of the patch, which are %s apart; %s",
                            FEWEST_SAMPLES,
                            Lengths.format(pitch),
                            pitch > COARSEST_PITCH
                                    ? "so far apart, samples show no structure that diffracts light: check the scan's"
                                            + " size and its unit"
                                    : "give " + Lengths.format(FEWEST_SAMPLES * pitch) + " or more"));
        }
    }

    /**
     * Refuses terms whose squares overflow float32; or, unless the user chose their number, which may be inaccurate, terms that exceed
     * float32's digits: they grow up to e^phase before they cancel.
     */
    private static TaylorExpansion requireFloats(TaylorExpansion expansion, boolean chosen, double tolerance) {
        double largest = expansion.largestTerm(expansion.maximumPhase());
        double reachable = Math.ulp(1f) * largest;
        if (chosen ? Math.pow(largest, 2) > Float.MAX_VALUE : reachable > tolerance) {
            String problem = chosen
                    ? Text.format("with %d terms leaves the range of float32", expansion.terms())
                    : Text.format("reaches only %.1g in float32", reachable);
            String relief = Text.format(
                    " at this relief (%s, phases up to %.1f); use lowrank",
                    Lengths.format(2 * expansion.scale().halfRange()), expansion.maximumPhase());
            throw SettingException.of(MethodSettings.EXPANSION, Expansion.Kind.TAYLOR, problem + relief);
        }
        return expansion;
    }

    private record Samplings(
            HeightMap heights, CieTable cie, GaussianArea area, VisibleRange range, ErrorBudget budget) {
        // 40 steps of 1 / lambda, 5 nm in the blue, 8 nm in the green, resolve the color matching functions and D65.
        private static final int FEWEST_NODES = 40;
        private static final int NODES_AT_STANDARD = 60;
        private static final double WAVELENGTH_STEP_AT_STANDARD = 4e-9;
        // Largest h^2 / (deviation * tolerance) of steps h within an order, meters: where the slope of D65 changes by
        // 1.1 % per nanometer, the trapezoid rule errs by up to h^2 / 12 times that, three tolerances.
        private static final double CORNER_LENGTH = 4e-6;
        // Largest |u|, |v| at which both axes are interpolated, with as many times more texels as the kernel has taps.
        private static final double LARGEST_CENTER = 0.2;
        // Wavelengths per period of the interference between top and bottom of the relief.
        private static final double NODES_PER_FRINGE = 6;
        // In bins; below, the flanks of orders are bare: interpolation errs relative to the order's middle, which is
        // exp(0.5^2 / sigma^2) times the power half a bin aside.
        private static final double RESOLVED_SIGMA_BINS = 0.4;

        /** Returns the samplings that keep the tolerance, the fastest first; later ones need less memory. */
        List<Supplier<Sampling>> choices() {
            if (!cie.isSmooth()) {
                // Half of the reference's step, whose error of 1e-6 of an order's maximum is too much on its flanks.
                double step = 0.5 * WindowLight.step(area.window(), heights, range.longestUv(), range.maximumW());
                return List.of(() -> new BinSampling(bins(), WavelengthNodes.integrated(cie, step), true));
            }
            // The next order, at least half a bin away, must vanish there, so that the valley between orders is dark.
            double sigmaBins = area.window().sigmaFrequency() * Math.max(heights.width(), heights.height());
            double neighbor = CoherenceWindow.amplitude(0.5 / sigmaBins);
            if (neighbor < 1e-3 * budget.tolerance()) {
                return List.of(this::orders);
            }
            Supplier<Sampling> fast = () -> grid(budget.interpolation(area.average()), false);
            Supplier<Sampling> compact = () -> grid(budget.compactInterpolation(area.average()), false);
            Supplier<Sampling> apart = () -> grid(budget.compactInterpolation(area.average()), true);
            Supplier<Sampling> bins = () -> new OrderSampling(bins(), Optional.empty(), band(fewestNodes()));
            // Where orders are resolved along an axis, a fine enough grid is larger than the bins.
            return interpolates(heights, area.window())
                    ? List.of(fast, compact, apart, bins)
                    : List.of(bins, fast, compact, apart);
        }

        private Neighborhood bins() {
            double sigma = area.window().sigmaFrequency();
            return new Neighborhood(
                    budget.neighborhoodRadius(sigma * heights.width()),
                    budget.neighborhoodRadius(sigma * heights.height()),
                    Neighborhood.Anchor.NEAREST);
        }

        private Neighborhood reached() {
            double reach = InterpolationDesign.GAUSS_REACH * area.window().sigmaFrequency();
            return new Neighborhood(
                    (int) Math.ceil(reach * heights.width()),
                    (int) Math.ceil(reach * heights.height()),
                    Neighborhood.Anchor.NEAREST);
        }

        private BandRule band(int fewestNodes) {
            double deviation = area.window().sigmaFrequencyOfPower();
            return BandRule.of(fewestNodes, deviation, budget.cutSpacing(), budget.panelDeviations());
        }

        static boolean interpolates(HeightMap map, CoherenceWindow window) {
            return window.sigmaFrequency() * Math.min(map.width(), map.height()) >= RESOLVED_SIGMA_BINS;
        }

        private Sampling orders() {
            // Trapezoid rule for a Gaussian of deviation 1: error 2 exp(-2 (pi / step)^2).
            double spacing = Math.min(1, Math.PI * Math.sqrt(2 / Math.log(2 / (0.01 * budget.tolerance()))));
            double reach = Math.max(3, CoherenceWindow.reach(0.1 * budget.tolerance()));
            OrderSampling.OrderNodes nodes = new OrderSampling.OrderNodes(
                    reach,
                    spacing,
                    budget.panelDeviations(),
                    WAVELENGTH_STEP_AT_STANDARD / relativeFineness(),
                    CORNER_LENGTH * budget.tolerance());
            // The window resolves each order of so small a patch: the bin nearest to a frequency suffices.
            Neighborhood nearest = new Neighborhood(0, Neighborhood.Anchor.NEAREST);
            return new OrderSampling(nearest, Optional.of(nodes), band(4 * fewestNodes()));
        }

        private GridSampling grid(InterpolationDesign design, boolean apart) {
            // Columns are crossed at up to sqrt(2) of their distance. An order's power along the ray has deviation
            // sigma / sqrt(2), for which the trapezoid rule errs by 2 exp(-2 (pi deviation / step)^2).
            double perStep = Math.sqrt(2 / (Math.PI * Math.PI) * Math.log(2 / budget.wavelengths()));
            double deviation = area.window().sigmaFrequencyOfPower();
            double uncut = area.window().sigmaFrequency() / perStep;
            boolean rough = budget.roughness().isRough();
            double step = rough ? uncut : Math.min(uncut, budget.cutSpacing() * deviation / Math.sqrt(2));
            BandRule band = rough ? band(fewestNodes()).withEqualSteps(uncut) : band(fewestNodes());
            double longest = Math.sqrt(2) * step;
            // Columns are closer where both axes would be interpolated too far out.
            double reach = fewestNodes() * step / CieTable.BAND_WIDTH;
            double closer = step / (int) Math.ceil(reach / LARGEST_CENTER);
            // Single wavelengths sum bins, or, beyond the limit of a shader's loops, have a grid for both averages.
            Sampling spectral = bins().bins() <= Sampling.MOST_LOOP_STEPS
                    ? new OrderSampling(bins(), Optional.empty(), band)
                    : new GridSampling(
                            new ErrorBudget(budget.tolerance()).interpolation(Average.ENSEMBLE),
                            reached(),
                            closer,
                            longest,
                            fewestNodes(),
                            band,
                            Optional.empty(),
                            apart,
                            budget);
            return new GridSampling(
                    design, reached(), closer, longest, fewestNodes(), band, Optional.of(spectral), apart, budget);
        }

        private double relativeFineness() {
            return Math.cbrt(ErrorBudget.STANDARD / budget.tolerance());
        }

        private int fewestNodes() {
            double fringes = (heights.maximum() - heights.minimum()) * range.maximumW() * CieTable.BAND_WIDTH;
            double resolving = NODES_AT_STANDARD * relativeFineness();
            return (int) Math.ceil(Math.max(FEWEST_NODES, Math.max(resolving, NODES_PER_FRINGE * fringes)));
        }
    }
}
