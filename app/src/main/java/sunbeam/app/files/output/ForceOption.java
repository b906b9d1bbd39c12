package sunbeam.app.files.output;

import picocli.CommandLine.Option;

/** The option {@code --force} of every command that writes files; to be used as a picocli mixin. */
public final class ForceOption {
    @Option(
            names = "--force",
            description = "Overwrite output files that exist. Without it a file that you name is never overwritten,"
                    + " and a name that Sunbeam chooses gets a number (-2, -3, ...) where it is taken.")
    private boolean force;

    /** What the user allows. */
    public Overwrite overwrite() {
        return force ? Overwrite.REPLACE : Overwrite.REFUSE;
    }
}
