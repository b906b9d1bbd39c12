package sunbeam.app.setup;

import java.util.OptionalDouble;
import java.util.OptionalInt;
import picocli.CommandLine.Option;
import sunbeam.app.cli.LengthConverter;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.resample.PeriodInterpolation;
import sunbeam.precompute.units.Lengths;

/** Which method; to be used as a picocli mixin. */
public final class MethodOptions {
    @Option(
            names = "--method",
            paramLabel = "METHOD",
            defaultValue = "full",
            description = "full (default): all wavelengths, Gaussian coherence window. nmm: one wavelength per"
                    + " diffraction order, weighted by the order's width. pq: the patch repeated Q times, sharp edge."
                    + " gem: a grating's spacing alone, for comparison only. reference: direct sums in double precision"
                    + " on the processor; slow, the truth; not for maps. See docs/methods.md.")
    private MethodKind method;

    @Option(
            names = "--interpolation",
            paramLabel = "KIND",
            description = "For pq: sinc (default) or linear between the bins of one period's DFT.")
    private PeriodInterpolation interpolation;

    @Option(
            names = "--replicas",
            paramLabel = "Q",
            description =
                    "For pq: repeat the patch Q times along both axes. Default: as fills the coherence length. With"
                            + " reference: the exact sum over the replicas instead of the Gaussian window.")
    private Integer replicas;

    @Option(
            names = "--spacing",
            paramLabel = "LENGTH",
            converter = LengthConverter.class,
            description = "For gem: distance of the grating's lines, which run along y. Default: the patch's width, for"
                    + " patches of one period.")
    private Double spacing;

    /**
     * The request, checked.
     *
     * @throws UsageException for a value that cannot be used, or that does not belong to the method
     */
    public MethodRequest request() {
        return request(method, interpolation, replicas, spacing);
    }

    /**
     * A request, checked; what was not given is null.
     *
     * @throws UsageException for a value that cannot be used, or that does not belong to the method
     */
    public static MethodRequest request(
            MethodKind method, PeriodInterpolation interpolation, Integer replicas, Double spacing) {
        boolean repeats = method == MethodKind.PQ || method == MethodKind.REFERENCE;
        rejectUnless(interpolation == null || method == MethodKind.PQ, "--interpolation", "pq", method);
        rejectUnless(replicas == null || repeats, "--replicas", "pq or reference", method);
        rejectUnless(spacing == null || method == MethodKind.GEM, "--spacing", "gem", method);
        if (replicas != null && (replicas < 1 || replicas > Replicas.MOST)) {
            throw new UsageException("--replicas " + replicas + " is out of range; give 1 to " + Replicas.MOST);
        }
        if (spacing != null
                && !(spacing >= MethodRequest.SMALLEST_SPACING && spacing <= MethodRequest.LARGEST_SPACING)) {
            throw new UsageException("--spacing %s is out of range; give %s to %s"
                    .formatted(
                            Lengths.format(spacing),
                            Lengths.format(MethodRequest.SMALLEST_SPACING),
                            Lengths.format(MethodRequest.LARGEST_SPACING)));
        }
        return new MethodRequest(
                method,
                interpolation == null ? PeriodInterpolation.SINC : interpolation,
                replicas == null ? OptionalInt.empty() : OptionalInt.of(replicas),
                spacing == null ? OptionalDouble.empty() : OptionalDouble.of(spacing));
    }

    private static void rejectUnless(boolean fits, String option, String methods, MethodKind method) {
        if (!fits) {
            throw new UsageException(
                    "%s belongs to --method %s, not %s; leave it out".formatted(option, methods, method.label()));
        }
    }
}
