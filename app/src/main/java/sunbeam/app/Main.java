package sunbeam.app;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.Charset;
import java.util.Locale;
import javax.swing.JOptionPane;
import jrtr.gl.DisplayFaults;
import sunbeam.app.cli.program.Sunbeam;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.Messages.HarmlessWriter;
import sunbeam.app.terminal.ShutdownHook;

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
        boolean hasNoConsole = Boolean.getBoolean("sunbeam.dialog"); // the start script's
        StringWriter errors = new StringWriter();
        PrintWriter err =
                hasNoConsole ? new PrintWriter(errors) : new PrintWriter(System.err, true, Charset.defaultCharset());
        DisplayFaults.onLoss(() -> endWithoutScreen(HarmlessWriter.around(err)));
        int code = new Sunbeam(Environment.ofProcess(), out, err).run(arguments);
        if (hasNoConsole && code != 0) {
            JOptionPane.showMessageDialog(null, errors, "Sunbeam", JOptionPane.ERROR_MESSAGE);
        }
        // A start script that cannot see how Java ended tells this code from those of a Java that died.
        System.exit(Integer.getInteger("sunbeam.exit", 0) + code);
    }

    /** Ends the process without Java's shutdown hooks, since those of JOGL would use the lost display. */
    private static void endWithoutScreen(PrintWriter err) {
        err.println(Messages.error("the X server of DISPLAY=" + System.getenv("DISPLAY")
                + " has ended, and with it the drawing; start it again, or unset DISPLAY for a private one"));
        ShutdownHook.runAll();
        Runtime.getRuntime().halt(ExitCode.NO_GRAPHICS.code());
    }
}
