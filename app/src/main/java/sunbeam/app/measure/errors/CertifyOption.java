package sunbeam.app.measure.errors;

import static sunbeam.precompute.plan.MethodSettings.ANCHOR;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Whether a run states its error; to be used as a picocli mixin. */
public final class CertifyOption {
    /** The same places are evaluated in every run. */
    public static final long SEED = 1;

    private static final int MOST = 100_000;
    private static final List<Setting<?>> OVERRIDES =
            List.of(PRESET, EXPANSION, TERMS, RADIUS, ANCHOR, WAVELENGTH_STEP);

    @Option(
            names = "--certify",
            paramLabel = "N",
            description =
                    "Evaluate N random places of this very result (pixels of a map, rows of a table) with the exact"
                            + " reference and state the error: median, 95th percentile and maximum relative error, and CIEDE2000"
                            + " of colors. At most a quarter of a map's pixels are dark while it has others. Exit code 3 when the"
                            + " median exceeds --tolerance or the 95th percentile three times it, where the plan cannot"
                            + " promise it, and where all places are dark.")
    private Integer certify;

    /**
     * How many places are evaluated, if any.
     *
     * @throws UsageException for a number out of range
     */
    public OptionalInt count() {
        if (certify != null && (certify < 1 || certify > MOST)) {
            throw new UsageException("--certify " + certify + " is out of range; give 1 to " + MOST);
        }
        return certify == null ? OptionalInt.empty() : OptionalInt.of(certify);
    }

    /**
     * The certificate, if one is asked for.
     *
     * @param evaluate makes it, given the number of places
     */
    public Optional<Certificate> certificate(IntFunction<Certificate> evaluate) {
        OptionalInt count = count();
        return count.isPresent() ? Optional.of(evaluate.apply(count.getAsInt())) : Optional.empty();
    }

    /**
     * Refuses what cannot be compared.
     *
     * @throws UsageException where a certificate is asked for and the method's light has no scale, or is the exact one
     */
    public void check(Method method) {
        if (count().isEmpty()) {
            return;
        }
        if (method instanceof ReferenceMethod) {
            throw new UsageException("--certify compares with --method reference; leave out one of them");
        }
        if (method.brightness() == Method.Brightness.UNRELATED) {
            throw new UsageException("--certify compares with a mirror's light, to which the colors of --method "
                    + method.type().label() + " do not relate; leave out --certify");
        }
    }

    /**
     * Prints what a certificate says, complains if the tolerance is missed or was not promised, and returns the exit code.
     *
     * @param plan that the result was made by
     * @param choices that the plan was made with
     */
    public static ExitCode judge(
            Certificate certificate, MethodPlan plan, Choices choices, PrintWriter out, PrintWriter err) {
        out.println("certificate: " + certificate.summary());
        out.flush();
        if (certificate.relative().count() == 0) {
            err.println(
                    Messages.error("the tolerance is not certified: none of these places has enough light; give more"));
            err.flush();
            return ExitCode.TOLERANCE_MISSED;
        }
        if (certificate.missed()) {
            err.println(Messages.error(certificate.complaint() + "; " + remedy(choices)));
            return ExitCode.TOLERANCE_MISSED;
        }
        if (!plan.shortfalls().isEmpty()) {
            err.println(Messages.error(String.format(
                    Locale.ROOT,
                    "these places keep the tolerance %.2g, but it is not promised for others: see the plan's warning",
                    certificate.tolerance())));
            return ExitCode.TOLERANCE_MISSED;
        }
        out.println("verdict: " + certificate.praise());
        out.flush();
        return ExitCode.OK;
    }

    /** A choice that overrides the plan, a method that approximates whatever is asked for, or neither. */
    private static String remedy(Choices choices) {
        Method method = Methods.of(choices);
        String overrides = OVERRIDES.stream()
                .filter(setting -> choices.has(setting) && method.type().has(setting))
                .filter(setting -> !setting.equals(PRESET) || choices.get(PRESET) != Preset.NONE)
                .map(OptionOrigin.INSTANCE::name)
                .collect(Collectors.joining(" and "));
        if (!overrides.isEmpty()) {
            return "leave out " + overrides + ", and the plan follows from the tolerance";
        }
        Optional<String> instead = method.instead().map(type -> "; give --method " + type.label());
        return method.approximation()
                .map(words -> method.type().label() + " is an approximation, whatever the tolerance: " + words
                        + instead.orElse(""))
                .orElse("give a finer --tolerance; 'reflectance --method reference' has the exact values");
    }
}
