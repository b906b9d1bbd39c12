package sunbeam.app;

import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.Locale;
import sunbeam.app.terminal.Environment;

/** Entry point of the {@code sunbeam} command. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        // The HDF5 library logs through SLF4J, which would complain on standard error that nobody listens.
        System.setProperty("slf4j.internal.verbosity", "ERROR");
        // Digits that programs read are 0 to 9 in every country; Swing keeps the user's language.
        Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT);
        PrintWriter out = new PrintWriter(System.out, true, Charset.defaultCharset());
        PrintWriter err = new PrintWriter(System.err, true, Charset.defaultCharset());
        int code = new Sunbeam(Environment.ofProcess(), out, err).run(arguments);
        System.exit(code);
    }
}
