package sunbeam.app.cache;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import sunbeam.app.cli.Environment;
import sunbeam.app.output.AtomicFile;
import sunbeam.app.output.OutputException;
import sunbeam.app.output.Overwrite;
import sunbeam.app.progress.Progress;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.PatchIdentity;
import sunbeam.precompute.table.TableBuilder;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.table.TableFile;

/** Fourier tables in the cache folder, by a hash of all that determines them; made where they are missing. */
public final class TableStore {
    private final Environment environment;
    private final Consumer<String> warning;

    public TableStore(Environment environment, Consumer<String> warning) {
        this.environment = environment;
        this.warning = warning;
    }

    /** The table for a plan, read or made. A file that is damaged is made again, with a word about it. */
    public FourierTable get(PatchIdentity patch, HeightLevels heights, Plan plan) {
        Optional<Path> folder = CacheFolder.of(environment).open(warning);
        Optional<Path> file = folder.map(path -> path.resolve(fileName(patch, plan)));
        if (file.isPresent() && Files.exists(file.get())) {
            try {
                return TableFile.read(file.get());
            } catch (TableException failure) {
                warning.accept("cached table is made again: " + failure.problem());
            }
        }
        FourierTable table = build(patch, heights, plan);
        file.ifPresent(path -> save(path, table));
        return table;
    }

    /** Makes a table, with progress. */
    public static FourierTable build(PatchIdentity patch, HeightLevels heights, Plan plan) {
        Expansion expansion = plan.expansion();
        try (Progress progress = Progress.start("Fourier tables", expansion.terms())) {
            int[] done = {0};
            TableBuilder builder = new TableBuilder(patch, heights, terms -> {
                progress.step(terms - done[0]);
                done[0] = terms;
            });
            return builder.build(expansion, plan.bandX(), plan.bandY());
        }
    }

    private void save(Path file, FourierTable table) {
        try {
            AtomicFile.writeFile(file, Overwrite.REPLACE, path -> TableFile.write(path, table));
        } catch (OutputException failure) {
            warning.accept("the table is not kept: " + failure.getMessage());
        }
    }

    private static String fileName(PatchIdentity patch, Plan plan) {
        Expansion expansion = plan.expansion();
        String key = String.join(
                "|",
                "table 1",
                patch.digest(),
                expansion.kind().label(),
                Integer.toString(expansion.terms()),
                Double.toHexString(expansion.scale().centre()),
                Double.toHexString(expansion.scale().halfRange()),
                Double.toHexString(expansion.minimumPhase()),
                Double.toHexString(expansion.maximumPhase()),
                plan.bandX().toString(),
                plan.bandY().toString());
        return Sha256.of(key).substring(0, 32) + ".h5";
    }
}
