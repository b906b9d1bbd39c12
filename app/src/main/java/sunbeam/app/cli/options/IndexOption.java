package sunbeam.app.cli.options;

import sunbeam.app.files.input.InputException;
import sunbeam.app.files.input.IndexFile;
import java.nio.file.Path;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.optics.RefractiveIndex;

/** {@code --index}: of what material the surface is; to be used as a picocli mixin. */
public final class IndexOption {
    @Option(
            names = "--index",
            paramLabel = "N",
            defaultValue = "1.5",
            description =
                    "Refractive index of the surface: a number (1.5, keratin, is the default), n+ki for metals and"
                            + " coats of metal (0.97+6.5i), or a CSV file in the form of refractiveindex.info, by wavelength.")
    private String index;

    /** The index that {@link #parse} gave, for metadata; a tabulated one with its file's name. */
    public String describe(RefractiveIndex parsed) {
        return IndexFile.isName(index) ? Path.of(index).getFileName() + ", " + parsed.describe() : parsed.describe();
    }

    /**
     * The index that was asked for.
     *
     * @throws UsageException for what is no index
     * @throws InputException for a file that cannot be used
     */
    public RefractiveIndex parse() {
        try {
            return IndexFile.isName(index) ? IndexFile.read(Path.of(index)) : RefractiveIndex.parse(index);
        } catch (IllegalArgumentException wrong) {
            throw new UsageException("--index " + index + ": " + wrong.getMessage());
        }
    }
}
