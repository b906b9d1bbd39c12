package sunbeam.app.measure.errors;

import java.io.PrintWriter;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntFunction;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;

/** Whether a run states its error; to be used as a picocli mixin. */
public final class CertifyOption {
    /** The same places are evaluated in every run. */
    public static final long SEED = 1;

    private static final int MOST = 100_000;

    @Option(
            names = "--certify",
            paramLabel = "N",
            description =
                    "Evaluate N random places of this very result (pixels of a map, rows of a table) with the exact"
                            + " reference and state the error: median, 95th percentile and maximum relative error, and CIEDE2000"
                            + " of colours. Exit code 3 when the median exceeds --tolerance or the 95th percentile three times"
                            + " it.")
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

    /** Prints what a certificate says, complains if the tolerance is missed, and returns the exit code. */
    public static ExitCode judge(Certificate certificate, PrintWriter out, PrintWriter err) {
        out.println("certificate: " + certificate.summary());
        if (!certificate.missed()) {
            return ExitCode.OK;
        }
        err.println(Messages.error(certificate.complaint()));
        return ExitCode.TOLERANCE_MISSED;
    }
}
