package sunbeam.app.cli.options;

import java.nio.file.Path;
import picocli.CommandLine.Option;
import sunbeam.app.files.input.IndexFile;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.optics.RefractiveIndex;

/** Option {@code --index}, the material of the surface; a picocli mixin. */
public final class IndexOption {
    @Option(
            names = "--index",
            paramLabel = "N",
            defaultValue = "1.5",
            description =
                    "Refractive index of the surface: a number (1.5, keratin, is the default), n+ki for metals and"
                            + " coats of metal (0.97+6.5i), or a CSV file in the form of refractiveindex.info, by wavelength.")
    private String index;

    /** Describes the result of {@link #parse} for metadata; a tabulated index with its file's name. */
    public String describe(RefractiveIndex parsed) {
        return IndexFile.isName(index) ? Path.of(index).getFileName() + ", " + parsed.describe() : parsed.describe();
    }

    /** Parses the option, or reads the file that it names; throws UsageException or InputException if they cannot be used. */
    public RefractiveIndex parse() {
        try {
            return IndexFile.isName(index) ? IndexFile.read(Path.of(index)) : RefractiveIndex.parse(index);
        } catch (IllegalArgumentException wrong) {
            throw new UsageException("--index " + index + ": " + wrong.getMessage());
        }
    }
}
