package sunbeam.app;

import java.io.PrintWriter;
import java.nio.charset.Charset;
import sunbeam.app.cli.Environment;

/** Entry point of the {@code sunbeam} command. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        PrintWriter out = new PrintWriter(System.out, true, Charset.defaultCharset());
        PrintWriter err = new PrintWriter(System.err, true, Charset.defaultCharset());
        int code = new Sunbeam(Environment.ofProcess(), out, err).run(arguments);
        System.exit(code);
    }
}
