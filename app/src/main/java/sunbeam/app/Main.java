package sunbeam.app;

import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.Locale;
import sunbeam.app.cli.program.Sunbeam;
import sunbeam.app.terminal.Environment;

/** Entry point of the {@code sunbeam} command. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        // The HDF5 library logs through SLF4J, which would complain on standard error about a missing back end.
        System.setProperty("slf4j.internal.verbosity", "ERROR");
        // JOML would use sun.misc.Unsafe, of which Java 24 and later warn.
        System.setProperty("joml.nounsafe", "true");
        // JOGL would try every version of OpenGL ES, too, which takes a quarter of a second.
        System.setProperty("jogl.disable.opengles", "true");
        // Numbers in files have the digits 0 to 9 in every locale; Swing's texts keep the user's language.
        Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT);
        PrintWriter out = new PrintWriter(System.out, true, Charset.defaultCharset());
        PrintWriter err = new PrintWriter(System.err, true, Charset.defaultCharset());
        int code = new Sunbeam(Environment.ofProcess(), out, err).run(arguments);
        System.exit(code);
    }
}
