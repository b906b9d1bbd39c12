package sunbeam.app.setup;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import picocli.CommandLine.Option;
import sunbeam.app.cli.LengthConverter;
import sunbeam.app.cli.Messages;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.Tolerances;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** What a user may fix of the plan; to be used as a picocli mixin. */
public final class PlanOptions {
    private static final int MOST_TERMS = 500;

    @Option(
            names = "--preset",
            paramLabel = "PRESET",
            description =
                    "thesis: 37 Taylor terms, 380..780 nm in steps of 5 nm, 3 x 3 bins anchored with floor, window"
                            + " on the corner. Options below override it one by one.")
    private Preset preset;

    @Option(
            names = "--tolerance",
            paramLabel = "ERROR",
            description = "Relative error of power and colour that the plan is made for, 1e-5 to 1. Default: 1e-3."
                    + " Below 2e-5 float32 keeps it in the median, but not three times it at the 95th percentile; for"
                    + " more, use 'reflectance --method reference'."
                    + " Options below override parts of the plan.")
    private Double tolerance;

    @Option(
            names = "--expansion",
            paramLabel = "KIND",
            description = "Expansion of exp(i k w h): taylor, chebyshev, lowrank.")
    private ExpansionKind expansion;

    @Option(names = "--terms", paramLabel = "N", description = "Number of its terms.")
    private Integer terms;

    @Option(
            names = "--radius",
            paramLabel = "R",
            description = "Sum (2 R + 1) x (2 R + 1) DFT bins around each frequency.")
    private Integer radius;

    @Option(names = "--anchor", paramLabel = "BIN", description = "The bin in their middle: floor (thesis) or nearest.")
    private Neighbourhood.Anchor anchor;

    @Option(
            names = "--wavelength-step",
            paramLabel = "LENGTH",
            converter = LengthConverter.class,
            description = "Equal steps of the wavelength, for example 5nm.")
    private Double wavelengthStep;

    @Option(
            names = "--window-origin",
            paramLabel = "PLACE",
            description =
                    "Where the coherence window's maximum lies on the patch: centre (default) or corner (thesis).")
    private WindowOrigin origin;

    @Option(
            names = "--coherence-length",
            paramLabel = "LENGTH",
            converter = LengthConverter.class,
            description = "Four standard deviations of the coherence window. Default: 65um, sunlight.")
    private Double coherenceLength;

    @Option(
            names = "--average",
            paramLabel = "KIND",
            description = "coherent (default): one coherence area, with its speckle. ensemble: the mean over all"
                    + " positions of the window.")
    private Average average;

    @Option(names = "--explain", description = "Say why each part of the plan is as it is.")
    private boolean explain;

    /** Names of presets. */
    private enum Preset {
        THESIS
    }

    /**
     * The request, checked.
     *
     * @throws UsageException for a value that cannot be used
     */
    public PlanRequest request() {
        checkTolerance();
        checkPreset();
        checkRange("--terms", terms, 1, MOST_TERMS);
        checkRange("--radius", radius, 0, Neighbourhood.MAXIMUM_RADIUS);
        checkLength("--wavelength-step", wavelengthStep, 1e-12, 200e-9);
        checkLength("--coherence-length", coherenceLength, 100e-9, 10e-3);
        return new PlanRequest(
                preset == Preset.THESIS ? PlanRequest.Preset.THESIS : PlanRequest.Preset.NONE,
                tolerance(),
                Optional.ofNullable(expansion),
                terms == null ? OptionalInt.empty() : OptionalInt.of(terms),
                radius == null ? OptionalInt.empty() : OptionalInt.of(radius),
                Optional.ofNullable(anchor),
                wavelengthStep == null ? OptionalDouble.empty() : OptionalDouble.of(wavelengthStep),
                Optional.ofNullable(origin),
                coherenceLength == null ? OptionalDouble.empty() : OptionalDouble.of(coherenceLength),
                Optional.ofNullable(average));
    }

    private double tolerance() {
        return tolerance == null ? Tolerances.STANDARD : tolerance;
    }

    /**
     * The request, checked, for a method that may make none of these choices.
     *
     * @throws UsageException for a value that cannot be used, or that does not belong to the method
     */
    public PlanRequest request(MethodKind method) {
        if (method == MethodKind.REFERENCE || method == MethodKind.GEM) {
            rejectGiven("--tolerance", tolerance, method);
            rejectGiven("--expansion", expansion, method);
            rejectGiven("--terms", terms, method);
            rejectGiven("--radius", radius, method);
            rejectGiven("--anchor", anchor, method);
            rejectGiven("--wavelength-step", wavelengthStep, method);
        }
        return request();
    }

    private static void rejectGiven(String option, Object value, MethodKind method) {
        if (value != null) {
            throw new UsageException("%s is about Fourier tables, which --method %s does not use; leave it out"
                    .formatted(option, method.label()));
        }
    }

    /** Prints a method's plan, with reasons where they are asked for, and what breaks its tolerance. */
    public void print(MethodPlan method, PrintWriter out) {
        print(method.summary(), method.reasons(), out);
        method.warnings().forEach(line -> out.println(Messages.warning(line)));
        out.flush();
    }

    private void print(String summary, List<String> reasons, PrintWriter out) {
        out.println("plan: " + summary);
        if (explain) {
            reasons.forEach(line -> out.println("  " + line));
        }
        out.flush();
    }

    /** The options that were given, for metadata. */
    public String describe() {
        StringBuilder text = new StringBuilder(preset == null ? "tolerance " + tolerance() : "preset thesis");
        append(text, "expansion", expansion);
        append(text, "terms", terms);
        append(text, "radius", radius);
        append(text, "anchor", anchor);
        append(text, "wavelength step (m)", wavelengthStep);
        append(text, "window origin", origin);
        append(text, "coherence length (m)", coherenceLength);
        append(text, "average", average);
        return text.toString();
    }

    private static void append(StringBuilder text, String name, Object value) {
        if (value != null) {
            text.append(", ").append(name).append(' ').append(value.toString().toLowerCase(Locale.ROOT));
        }
    }

    private void checkTolerance() {
        double value = tolerance();
        if (!(value > 0 && value <= Tolerances.COARSEST)) {
            throw new UsageException("--tolerance %s is out of range; give %s to %s, for example 1e-3"
                    .formatted(
                            Decimals.format(value),
                            Decimals.format(Tolerances.FINEST),
                            Decimals.format(Tolerances.COARSEST)));
        }
        if (value < Tolerances.FINEST) {
            throw new UsageException(
                    "--tolerance %s is finer than float32 can reach, which is %s; give that or more, or evaluate directions with 'reflectance --method reference'"
                            .formatted(Decimals.format(value), Decimals.format(Tolerances.FINEST)));
        }
    }

    private void checkPreset() {
        if (preset != null && tolerance != null) {
            throw new UsageException(
                    "--tolerance %s contradicts --preset %s, whose choices keep no tolerance; leave one of them out"
                            .formatted(
                                    Decimals.format(tolerance),
                                    preset.toString().toLowerCase(Locale.ROOT)));
        }
    }

    private static void checkRange(String option, Integer value, int low, int high) {
        if (value != null && (value < low || value > high)) {
            throw new UsageException("%s %d is out of range; give %d to %d".formatted(option, value, low, high));
        }
    }

    private static void checkLength(String option, Double metres, double low, double high) {
        if (metres != null && !(metres >= low && metres <= high)) {
            throw new UsageException("%s %s is out of range; give %s to %s"
                    .formatted(option, Lengths.format(metres), Lengths.format(low), Lengths.format(high)));
        }
    }
}
