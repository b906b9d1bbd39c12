package sunbeam.app.cli.options;

import picocli.CommandLine.Option;

/**
 * Options of a command that takes several surfaces, folders and angles of the light; a picocli mixin. {@code cli.collection.Collection} runs
 * the command once for each.
 */
public final class CollectionOptions {
    /** Option that takes a part of the surfaces. */
    public static final String TASK = "--task";

    @Option(
            names = TASK,
            paramLabel = "I/N",
            description = "Of several patches, folders and angles take the I-th of N parts. The same command without"
                    + " it, with --resume, then joins all.")
    @SuppressWarnings("UnusedVariable") // read from the command line before the command runs
    private String task;
}
