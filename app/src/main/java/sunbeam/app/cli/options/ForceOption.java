package sunbeam.app.cli.options;

import java.nio.file.Path;
import picocli.CommandLine.Option;
import sunbeam.app.files.output.Overwrite;

/** The option {@code --force} of every command that writes files; to be used as a picocli mixin. */
public final class ForceOption {
    @Option(
            names = "--force",
            description = "Overwrite output files that exist. Without it a file that you name is never overwritten,"
                    + " and a name that Sunbeam chooses gets a number (-2, -3, ...) where it is taken.")
    private boolean force;

    /** What the user allows where a file stands that the user named. */
    public Overwrite overwrite() {
        return force ? Overwrite.REPLACE : Overwrite.REFUSE;
    }

    /**
     * What the user allows, also where Sunbeam chooses the name.
     *
     * @param named the name that the user gave, or null
     */
    public Overwrite overwrite(Path named) {
        return force || named != null ? overwrite() : Overwrite.NUMBER;
    }
}
