package sunbeam.app.cli.options;

import java.io.PrintWriter;
import java.util.Optional;
import picocli.CommandLine.Option;
import sunbeam.app.files.output.TevClient;

/** Option {@code --tev} of commands that draw pictures; a picocli mixin. */
public final class TevOption {
    @Option(
            names = "--tev",
            description = "Also send the linear colors (Rec. 709 and alpha, before exposure) to the viewer tev, which"
                    + " has to run on this machine (port 14158): scenes tile by tile, maps when they are drawn.")
    private boolean asked;

    /** Returns the connection to tev, which must run; empty without the option. */
    public Optional<TevClient> connect(PrintWriter err) {
        return asked ? Optional.of(TevClient.connect(TevClient.PORT, err)) : Optional.empty();
    }
}
