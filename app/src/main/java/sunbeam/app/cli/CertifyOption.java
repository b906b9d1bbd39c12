package sunbeam.app.cli;

import static sunbeam.precompute.plan.MethodSettings.ANCHOR;
import static sunbeam.precompute.plan.MethodSettings.EXPANSION;
import static sunbeam.precompute.plan.MethodSettings.PRESET;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.WAVELENGTH_STEP;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import picocli.CommandLine.Option;
import sunbeam.app.scene.Scene;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Option {@code --certify}, a picocli mixin: compares random samples of a result with the exact reference, or with method full. */
public final class CertifyOption {
    private static final int MOST_SAMPLES = 100_000;
    private static final List<Setting<?>> OVERRIDES =
            List.of(PRESET, EXPANSION, TERMS, RADIUS, ANCHOR, WAVELENGTH_STEP);

    @Option(
            names = "--certify",
            paramLabel = "N",
            description =
                    "Compare N random places of this very result with the exact reference and state the error: median,"
                            + " 95th percentile and maximum relative error, and CIEDE2000 of colors. In a map the places are pixels, at most a"
                            + " quarter of them dark if there are enough others; in a table they are rows. Exit code 3 means that the"
                            + " median exceeds --tolerance, that the 95th percentile exceeds three times --tolerance, or that the plan"
                            + " cannot promise the tolerance. In a picture or an animation's first frame, each pixel is compared with"
                            + " 256 points in it by method full at tolerance 5e-3. There, exit code 3 means that the median exceeds"
                            + " 2 %% or the mean CIEDE2000 exceeds 1; under an environment, where table has 64 points under 16384 lights,"
                            + " 2.8 %% or 1.4. The code is also 3 if all places are dark.")
    private Integer certify;

    /** Returns the number of samples to compare; empty without the option. Refuses numbers out of range. */
    public Optional<Integer> count() {
        if (certify != null) {
            UsageException.requireWithin("--certify", certify, 1, MOST_SAMPLES);
        }
        return Optional.ofNullable(certify);
    }

    /** Refuses methods that cannot be compared: the reference itself, and those whose colors are not relative to a mirror's. */
    public void check(Method method) {
        boolean isGiven = count().isPresent();
        UsageException.throwIf(
                isGiven && method instanceof ReferenceMethod,
                "--certify compares with --method reference; leave out one of them");
        UsageException.throwIf(
                isGiven && !method.isNormalizedToMirror(),
                "--certify compares with a mirror's light, to which the colors of --method "
                        + method.type().label() + " do not relate; leave out --certify");
    }

    /** Refuses scenes whose method is neither full nor table, or has the thesis's preset: they differ from method full by design. */
    public void check(Scene scene) {
        MethodType type = scene.method().type();
        boolean points = type.equals(FullMethod.TYPE) || type.equals(TableMethod.TYPE);
        UsageException.throwIf(
                count().isPresent() && (scene.method().isThesis() || !points),
                "--certify compares with method full at a tolerance, from which "
                        + (scene.method().isThesis() ? "the thesis's preset" : "method " + type)
                        + " differs by design; leave out --certify");
    }

    public static ExitCode judge(
            Optional<Certificate> certificate, MethodPlan plan, Choices choices, PrintWriter out, PrintWriter err) {
        return certificate
                .map(stated -> judge(stated, plan.shortfalls().isEmpty(), remedy(choices, plan), out, err))
                .orElse(ExitCode.OK);
    }

    /** Prints a certificate, complains if its limits are missed or not promised by the plan for all places, and returns the exit code. */
    public static ExitCode judge(
            Certificate certificate, boolean promised, String remedy, PrintWriter out, PrintWriter err) {
        out.println("certificate: " + certificate.summary());
        if (certificate.relative().count() > 0 && !certificate.missed() && promised) {
            out.println(
                    "verdict: these places keep the tolerance: " + certificate.comparison() + ". That is the error of"
                            + " computing the model; what the model leaves out (docs/theory.md) comes on top");
            return ExitCode.OK;
        }
        String complaint = certificate.relative().count() == 0
                ? "the tolerance is not certified: none of these places has enough light; give more"
                : certificate.missed()
                        ? "the tolerance is missed: " + certificate.comparison() + "; " + remedy
                        : "these places keep the tolerance, but it is not promised for others: see the plan's warning";
        err.println(Messages.error(complaint));
        return ExitCode.TOLERANCE_MISSED;
    }

    static String remedy(Choices choices, MethodPlan plan) {
        Method method = Methods.of(choices);
        String overrides = OVERRIDES.stream()
                .filter(setting -> choices.has(setting) && method.type().has(setting))
                .filter(setting -> !setting.equals(PRESET) || choices.get(PRESET) != Preset.NONE)
                .map(OptionOrigin.INSTANCE::name)
                .collect(Collectors.joining(" and "));
        if (!overrides.isEmpty()) {
            return "leave out " + overrides + ", and the plan follows from the tolerance";
        }
        return method.approximation()
                .map(words -> method.type().label() + " is an approximation, whatever the tolerance: "
                        + words.in(OptionOrigin.INSTANCE))
                .orElse((plan.shortfalls().isEmpty()
                                ? "give a finer --tolerance; "
                                : "no finer --tolerance helps, see the plan's warning; ")
                        + "'reflectance --method reference' has the exact values");
    }
}
