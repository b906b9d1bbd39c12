package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.patch.PatchFault;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Whether a scan tells its period, and what must be said beside it: one judgement for all commands, in the same words. */
public final class PeriodJudgement {
    // From one end of the scan to the other; less goes into the interval.
    private static final double LARGEST_DRIFT = 1.05;
    // Ends of the interval: a period that may be half as large again is none.
    private static final double VAGUEST = 1.5;
    // Below, a wave is little longer than its mirror image at half the sampling frequency, and any shorter one looks
    // like it.
    private static final double FEWEST_SAMPLES = 3;
    private static final int DIGITS = 3;
    private static final String MIXED = ", or of a longer one if every second row is shifted (trace and retrace mixed)";

    // Of rows that are no measurement: what repeats in them is not the surface, and where they end is no edge of it.
    private static final double MOST_UNMEASURED = 0.02;

    private PeriodJudgement() {}

    /** Why rows that were not measured keep a scan from telling any period, and what leaves them out; empty where they do not. */
    public static Optional<String> spoilt(List<PatchFault> faults) {
        double share = faults.stream().mapToDouble(PatchFault::unmeasured).sum();
        return faults.stream()
                .filter(fault -> share > MOST_UNMEASURED && fault.unmeasured() > 0)
                .findFirst()
                .map(fault -> "no period is told of a scan of which " + fault.line());
    }

    /**
     * Why no period is told, and what helps; empty where one is.
     *
     * @param faults of the scan
     * @param estimate what the scan tells; empty where too few periods can be followed
     * @param peak of the spectrum that it starts from
     */
    public static Optional<String> refusal(
            List<PatchFault> faults, Optional<PeriodEstimate> estimate, SpectrumPeak peak) {
        return spoilt(faults).or(() -> refusal(estimate, peak));
    }

    private static Optional<String> refusal(Optional<PeriodEstimate> estimate, SpectrumPeak peak) {
        if (estimate.isEmpty()) {
            return Optional.of(String.format(
                    Locale.ROOT,
                    "repeats after about %s, but too few of these periods fit into the scan along their direction to say how well that is known; take a scan that is longer along it",
                    shortly(peak.period())));
        }
        PeriodEstimate told = estimate.get();
        if (told.doubt() == PeriodEstimate.Doubt.ALIAS || told.doubt() == PeriodEstimate.Doubt.LEVELLED_ROWS) {
            // Why it may drift, or be uneven, too.
            return doubt(told);
        }
        if (told.drift().isPresent() && told.drift().get().ratio() > LARGEST_DRIFT) {
            return Optional.of(String.format(
                    Locale.ROOT,
                    "no single period: it changes from about %s at one end of the scan to %s at the other; take a part of the scan",
                    shortly(told.drift().get().first()),
                    shortly(told.drift().get().last())));
        }
        if (!(told.high() <= VAGUEST * told.low())) {
            return Optional.of(String.format(
                    Locale.ROOT,
                    "repeats after about %s, but so unevenly that this scan does not tell the period (95 %% interval %s to %s); take a larger scan",
                    shortly(told.period()),
                    shortly(told.low()),
                    Double.isFinite(told.high()) ? shortly(told.high()) : "any length"));
        }
        return doubt(told);
    }

    private static Optional<String> doubt(PeriodEstimate told) {
        return switch (told.doubt()) {
            case NONE -> Optional.empty();
            case CHANCE ->
                Optional.of(String.format(
                        Locale.ROOT,
                        "straight lines some %s apart, but no grating: their wave comes and goes, and other distances are about as strong, as where chance put the lines, or dust and damage lie on them; scan another place to see whether it tells the same",
                        Lengths.rounded(told.period(), 2)));
            case HALF_SHIFTED ->
                Optional.of(String.format(
                        Locale.ROOT,
                        "every second row seems to be shifted by half of a period of about %s, as where trace and retrace are mixed (save one of them alone); what is left repeats after %s",
                        shortly(2 * told.period()),
                        shortly(told.period())));
            case ALIAS ->
                Optional.of(String.format(
                        Locale.ROOT,
                        "what seems to repeat after about %s may be no more than what sampling has made of finer lines, which hold much of the heights and diffract no visible light; scan finer to see whether it stays",
                        Lengths.rounded(told.period(), 2)));
            case LEVELLED_ROWS ->
                Optional.of(String.format(
                        Locale.ROOT,
                        "lines some %s apart run nearly along the rows, and each row has been levelled by itself, which takes a part of them and bends the rest; take the scan as it was before, or turn it by 90 degrees on the microscope",
                        Lengths.rounded(told.period(), 2)));
        };
    }

    /** Samples a period along the axis along which it has fewer; infinite along a single row or column. */
    public static double samplesAPeriod(HeightMap scan, SpectrumPeak peak) {
        double alongX = scan.columns() > 1 ? Math.abs(peak.frequencyX()) * scan.pitchX() : 0;
        double alongY = scan.rows() > 1 ? Math.abs(peak.frequencyY()) * scan.pitchY() : 0;
        return 1 / Math.max(alongX, alongY);
    }

    /**
     * What must be said of a period of few samples: no heights tell it from a shorter one, nor from a longer one of which every
     * second row is shifted by half of it. Empty of others.
     */
    public static Optional<String> alias(HeightMap scan, SpectrumPeak peak) {
        double samples = samplesAPeriod(scan, peak);
        boolean alongColumns = Math.abs(peak.frequencyY()) * scan.pitchY() > 1 / FEWEST_SAMPLES;
        return samples >= FEWEST_SAMPLES
                ? Optional.empty()
                : Optional.of(Decimals.rounded(samples, 2) + " samples a period: it may be the alias of a shorter one"
                        + (alongColumns ? MIXED : "") + "; scan finer to be sure");
    }

    private static String shortly(double metres) {
        return Lengths.rounded(metres, DIGITS);
    }
}
