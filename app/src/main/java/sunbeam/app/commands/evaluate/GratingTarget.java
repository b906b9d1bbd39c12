package sunbeam.app.commands.evaluate;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.analysis.FewPeriods;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.PeriodJudgement;
import sunbeam.precompute.analysis.PeriodRemedy;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.analysis.WaveDirection;
import sunbeam.precompute.evaluation.FirstOrder;
import sunbeam.precompute.evaluation.GratingMeasurement;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.units.Lengths;

/**
 * What an evaluation aims at, from what the user says and what the heights show.
 *
 * @param patch whose period it is
 * @param plane light and viewers
 * @param order where the first order is looked for
 * @param heights the regularities of the heights along the plane, or in all directions
 * @param wave of the heights that the estimate starts from; empty where there is none near the order
 * @param estimate what the heights tell of the period; empty where the user looks for one that they do not show
 * @param doubt why the heights tell no such period; empty where they do
 */
record GratingTarget(
        Patch patch,
        GratingPlane plane,
        FirstOrder order,
        Periodicity heights,
        Optional<SpectrumPeak> wave,
        Optional<PeriodEstimate> estimate,
        String doubt) {
    // A surface that repeats one small patch has its exact period; a grown one strays from the heights' mean period by
    // up to a quarter from one coherence area to the next.
    private static final double EXACT = 1.1;
    private static final double GROWN = 1.35;
    private static final double GIVEN = 1.2;
    // Of the cosine between a wave and the direction in which light looks at it: 15 degrees.
    private static final double ALONG = 0.966;
    // Parts of the progress: the heights' spectrum, its peaks, the phase of one of them. Estimated; only the time left
    // rests on them.
    private static final int SPECTRUM = 5;
    private static final int SEARCH = 3;
    private static final int ESTIMATE = 2;
    private static final int DIGITS = 3;

    /**
     * Aims.
     *
     * @throws NoPeriodException where neither the user nor the heights name a period
     */
    static GratingTarget of(Patch patch, GratingRequest request, double sigmaFrequency) {
        try (Progress progress = Progress.start("Heights of " + patch.name(), SPECTRUM + SEARCH + ESTIMATE)) {
            return of(patch, request, sigmaFrequency, progress);
        }
    }

    private static GratingTarget of(Patch patch, GratingRequest request, double sigmaFrequency, Progress progress) {
        PeriodFinder finder = new PeriodFinder(patch.scan(), patch.repetition() != Patch.Repetition.NONE);
        progress.step(SPECTRUM);
        OptionalDouble given = request.azimuth();
        Periodicity heights = given.isPresent() ? finder.along(given.getAsDouble(), sigmaFrequency) : finder.all();
        progress.step(SEARCH);
        Optional<String> spoilt = PeriodJudgement.spoilt(patch.faults());
        if (!heights.found()
                && spoilt.isPresent()
                && (given.isEmpty() || request.period().isEmpty())) {
            throw new NoPeriodException(patch.name() + ": " + spoilt.get());
        }
        if (!heights.found() && (given.isEmpty() || request.period().isEmpty())) {
            String where = given.isEmpty()
                    ? ""
                    : String.format(Locale.ROOT, " along azimuth %s degrees", Degrees.text(given.getAsDouble()));
            String asked = given.isEmpty() ? "--azimuth and --period" : "--period, or choose another --azimuth";
            String why = few(patch, given)
                    .map(wave -> "whether " + patch.name() + " repeats itself" + where
                            + " cannot be told from a scan of this size: " + wave + "; scan a larger area")
                    .orElseGet(() -> patch.name() + " has no periodicity" + where + ": " + heights.describeFigure());
            throw new NoPeriodException(why
                    + finder.spectrum(heights)
                            .describeBeyond()
                            .map(beyond -> "; " + beyond)
                            .orElse("")
                    + remedy(patch, given) + "; to look for a ridge all the same give " + asked);
        }
        FirstOrder order = request.period().isPresent()
                ? FirstOrder.around(request.period().getAsDouble(), GIVEN)
                : FirstOrder.around(heights.peaks().get(0).period(), spread(heights));
        Optional<SpectrumPeak> near = heights.peaks().stream()
                .filter(peak -> peak.period() >= order.shortest() && peak.period() <= order.longest())
                .findFirst();
        double azimuth = given.orElseGet(
                () -> signed(near.orElseGet(() -> heights.peaks().get(0))));
        Optional<PeriodEstimate> estimate =
                near.filter(peak -> spoilt.isEmpty()).flatMap(peak -> estimate(patch, heights, peak));
        if (request.period().isEmpty()) {
            requireTold(patch, estimate, heights.peaks().get(0));
        }
        Optional<String> doubted = near.filter(
                        peak -> estimate.filter(told -> told.doubt() != PeriodEstimate.Doubt.NONE)
                                .isPresent())
                .flatMap(peak -> PeriodJudgement.refusal(patch.faults(), estimate, peak));
        Optional<PeriodEstimate> told = doubted.isPresent() ? Optional.empty() : estimate;
        String doubt =
                told.isPresent() ? "" : spoilt.or(() -> doubted).orElseGet(() -> doubt(patch, given, heights, near));
        return new GratingTarget(patch, request.plane(azimuth), order, heights, near, told, doubt);
    }

    /** Why no period is told near one that was asked for. */
    private static String doubt(Patch patch, OptionalDouble azimuth, Periodicity heights, Optional<SpectrumPeak> near) {
        if (near.isPresent()) {
            return "too few of these periods fit into the scan along their direction to follow them";
        }
        return heights.found()
                ? "the heights show about " + shortly(heights.peaks().get(0).period()) + ", and none near --period"
                : few(patch, azimuth).orElseGet(() -> "the heights show no periodicity: " + heights.describeFigure())
                        + remedy(patch, azimuth);
    }

    /** A wave along the azimuth that is seen too few times. */
    private static Optional<String> few(Patch patch, OptionalDouble azimuth) {
        return FewPeriods.in(patch.scan())
                .filter(wave -> isAlong(azimuth, wave.direction()))
                .map(FewPeriods::describe);
    }

    private static boolean isAlong(OptionalDouble azimuth, double direction) {
        return azimuth.isEmpty() || Math.abs(Math.cos(direction - azimuth.getAsDouble())) >= ALONG;
    }

    /** The end of a sentence that says what shows a period along the azimuth; empty where nothing does. */
    private static String remedy(Patch patch, OptionalDouble azimuth) {
        return PeriodRemedy.in(patch.scan())
                .filter(remedy -> isAlong(azimuth, remedy.direction()))
                .map(remedy -> "; but " + remedy.describe(patch, OptionOrigin.INSTANCE))
                .orElse("");
    }

    /** The direction of the wave, with its interval; empty where the scan does not tell it, or knows it exactly. */
    Optional<WaveDirection> direction() {
        return heights.edges() == HeightSpectrum.Edges.PERIODIC
                ? Optional.empty()
                : wave.flatMap(peak -> estimate.flatMap(told -> WaveDirection.of(patch.scan(), peak, told)));
    }

    /** What must be said of a wave of few samples a period; empty of others, and of surfaces that repeat without end. */
    Optional<String> alias() {
        return heights.edges() == HeightSpectrum.Edges.PERIODIC
                ? Optional.empty()
                : wave.flatMap(peak -> PeriodJudgement.alias(patch.scan(), peak));
    }

    /** Whether the ridge has the digits of a grating's: its surface repeats without end, or its period is told. */
    boolean isSharp() {
        return estimate.isPresent() || (heights.found() && heights.edges() == HeightSpectrum.Edges.PERIODIC);
    }

    private static Optional<PeriodEstimate> estimate(Patch patch, Periodicity heights, SpectrumPeak peak) {
        return heights.edges() == HeightSpectrum.Edges.PERIODIC
                ? Optional.of(PeriodEstimate.exact(peak.period(), 1))
                : PeriodEstimator.estimate(patch.scan(), peak);
    }

    /** A figure that nobody should quote is not given. */
    private static void requireTold(Patch patch, Optional<PeriodEstimate> estimate, SpectrumPeak peak) {
        PeriodJudgement.refusal(patch.faults(), estimate, peak).ifPresent(refusal -> {
            throw new NoPeriodException(
                    patch.name() + ": " + refusal + "; to look for a ridge all the same give --period");
        });
    }

    private static String shortly(double metres) {
        return Lengths.format(new BigDecimal(metres).round(new MathContext(3)).doubleValue());
    }

    /**
     * Where light is looked at to check what the heights tell: near their period.
     *
     * @param told by the heights
     */
    static FirstOrder near(PeriodEstimate told) {
        return FirstOrder.around(told.period(), Math.max(EXACT, Math.min(GROWN, told.high() / told.low())));
    }

    private static double spread(Periodicity heights) {
        return heights.edges() == HeightSpectrum.Edges.PERIODIC ? EXACT : GROWN;
    }

    /** The direction between -90 and 90 degrees: a grating along x, a little off, is lit from +x. */
    private static double signed(SpectrumPeak peak) {
        double direction = peak.direction();
        return direction > Math.PI / 2 ? direction - Math.PI : direction;
    }

    /**
     * Measures a response; empty where it has no ridge and the heights tell the period all the same.
     *
     * @throws NoPeriodException where neither tells one
     */
    Optional<GratingMeasurement> measure(ResponseMatrix response, double sigmaFrequency) {
        Optional<GratingMeasurement> found = GratingMeasurement.of(response, order, sigmaFrequency);
        if (found.isEmpty() && estimate.isEmpty()) {
            throw new NoPeriodException(
                    patch.name() + ": " + noRidge() + ", or --period" + (doubt.isEmpty() ? "" : " (" + doubt + ")"));
        }
        return found;
    }

    /** What is said of a response without one. */
    String noRidge() {
        return String.format(
                Locale.ROOT,
                "the response has no ridge of periods from %s to %s at 3 --wavelengths or more within --angles; choose more of them",
                Lengths.rounded(order.shortest(), DIGITS),
                Lengths.rounded(order.longest(), DIGITS));
    }
}
