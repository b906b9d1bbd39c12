package sunbeam.app.files.cache;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Function;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.ColorSources;
import sunbeam.precompute.colortable.KeptPages;
import sunbeam.precompute.colortable.TriedTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.method.LevelledPlan;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.method.TableSources;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTablesFile;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.TableBuilder;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.table.TableFile;
import sunbeam.precompute.table.TableLabel;

/**
 * Tables of one surface in the cache folder, each under a hash of all that determines it; made where they are missing. A
 * file that is damaged or of something else is made again, with a word about it.
 */
public final class TableStore {
    private final Surface surface;
    private final CacheFolder folder;
    private final Consumer<String> warning;
    private final TriedTable.Told told;

    /**
     * Tables of a surface.
     *
     * @param note told in one line each what takes longer than planned
     * @param warning told in one line each what goes wrong with the cache, or falls short
     */
    public TableStore(Surface surface, Environment environment, Consumer<String> note, Consumer<String> warning) {
        this.surface = surface;
        this.folder = CacheFolder.of(environment);
        this.warning = warning;
        this.told = new TriedTable.Told() {
            @Override
            public void delay(String line) {
                note.accept(line);
            }

            @Override
            public void shortfall(String line) {
                warning.accept(line);
            }
        };
    }

    /**
     * What a method's shader reads, as it lies in the cache. Nothing is computed where it is there, and layer by layer, on
     * the way to the file, where it is not. Without a cache folder, layers are computed when they are asked for.
     *
     * @param colors who evaluates shaders, for tables that are made of colors
     */
    public ShaderTables tables(MethodPlan plan, MethodUse use, ColorSources colors) {
        return tables(plan, use, colors, share -> {});
    }

    /**
     * As {@link #tables(MethodPlan, MethodUse, ColorSources)}.
     *
     * @param progress told before each layer that is made the share that is done; goes on when it returns
     */
    public ShaderTables tables(MethodPlan plan, MethodUse use, ColorSources colors, DoubleConsumer progress) {
        String key = "shader tables " + ShaderTablesFile.VERSION + "|" + plan.key(use);
        Optional<Path> file = file(key, CacheEntry.SHADER);
        if (file.isEmpty()) {
            return freshTables(plan, use, colors).preceded(progress);
        }
        if (plan.memory().textureBytes() > folder.largest(warning)) {
            // Larger than what is kept: what it is made of is not, and takes most of the time.
            return made(plan, use, colors, this::table).preceded(progress);
        }
        Function<Path, ShaderTables> reader = path -> ShaderTablesFile.read(path, key);
        return keptOr(file.get(), reader, () -> {
            TableLabel label = label(plan);
            // Colors take up to hours: a run that is stopped leaves those that it has.
            List<Path> unfinished = new ArrayList<>();
            TableLabel half = new TableLabel(label.patch(), "half made: " + label.what());
            ShaderTables made = freshTables(plan, use, (tables, places) -> {
                        String again = key + "|" + unfinished.size();
                        Optional<Path> keeping = file(again, CacheEntry.COLORS);
                        keeping.ifPresent(unfinished::add);
                        return keeping.isEmpty()
                                ? colors.of(tables, places)
                                : KeptColors.of(keeping.get(), again, half, () -> colors.of(tables, places));
                    })
                    .preceded(progress);
            TableLabel tried = made.trial().isEmpty()
                    ? label
                    : new TableLabel(label.patch(), "table in " + made.trial() + "; planned as " + label.what());
            save(file.get(), path -> ShaderTablesFile.write(path, key, tried, made));
            unfinished.forEach(KeptColors::delete);
            // Again from the file, so that no more than one layer at a time need be in memory.
            return read(file.get(), reader).orElse(made);
        });
    }

    private TableLabel label(MethodPlan plan) {
        return TableLabel.of(surface.identity().name(), surface.identity().digest(), plan.summary());
    }

    private static String pagesKey(LevelledPlan plan) {
        return String.join(
                "|",
                "pages " + ShaderTablesFile.VERSION,
                plan.key(MethodUse.COLOR),
                String.valueOf(plan.tolerance()),
                plan.spectrum().map(Plan::key).orElse(""));
    }

    /** Whether there is a file of such pages; it may be damaged. */
    boolean hasPages(LevelledPlan plan) {
        return file(pagesKey(plan), CacheEntry.PAGES).filter(Files::exists).isPresent();
    }

    /** Pages of levels of colors that are kept for later runs; none without a cache folder. */
    KeptPages pages(LevelledPlan plan) {
        String key = pagesKey(plan);
        TableLabel label = label(plan);
        Optional<Path> file = file(key, CacheEntry.PAGES);
        if (file.isEmpty()) {
            return KeptPages.NONE;
        }
        Path path = file.get();
        long most = folder.limit(warning);
        KeptPages pages = PageFile.of(
                path,
                key,
                plan.levels().numbers(),
                label,
                folder.largest(warning),
                warning,
                () -> folder.shrink(most, Optional.of(path)));
        folder.used(path);
        folder.shrink(most, file);
        return pages;
    }

    /** What is in the file, else what is made, by one process at a time. */
    private <T> T keptOr(Path file, Function<Path, T> reader, Supplier<T> made) {
        Optional<T> kept = read(file, reader);
        if (kept.isPresent()) {
            return kept.get();
        }
        try (CacheLock lock = CacheLock.of(file, warning)) {
            Optional<T> ofAnother = lock.waited() ? read(file, reader) : Optional.empty();
            return ofAnother.orElseGet(made);
        }
    }

    /** What a method's shader reads, made now. */
    public ShaderTables freshTables(MethodPlan plan, MethodUse use, ColorSources colors) {
        return made(plan, use, colors, this::freshTable);
    }

    private ShaderTables made(
            MethodPlan plan, MethodUse use, ColorSources colors, Function<Plan, FourierTable> fourier) {
        return plan.tables(use, new TableSources() {
            @Override
            public FourierTable fourier(Plan needed) {
                return fourier.apply(needed);
            }

            @Override
            public ColorSource colors(ShaderTables tables, long places) {
                return colors.of(tables, places);
            }

            @Override
            public ColorSource shown(Function<LongConsumer, ColorSource> source, long places) {
                return ProgressColors.of(source, places);
            }

            @Override
            public TriedTable.Told told() {
                return told;
            }
        });
    }

    /** The Fourier table for a plan. */
    public FourierTable table(Plan plan) {
        return table(plan, Runnable::run);
    }

    /**
     * The Fourier table for a plan.
     *
     * @param saving takes what keeps the table for later runs, if it was made now: whoever is in haste does so afterwards
     */
    FourierTable table(Plan plan, Consumer<Runnable> saving) {
        Optional<Path> file =
                file("table 1|" + surface.identity().digest() + "|" + plan.tableKey(), CacheEntry.FOURIER);
        if (file.isEmpty()) {
            return freshTable(plan);
        }
        return keptOr(file.get(), present -> checked(TableFile.read(present), plan), () -> {
            FourierTable table = freshTable(plan);
            saving.accept(() -> save(file.get(), target -> TableFile.write(target, table)));
            return table;
        });
    }

    /** A table that was read, under the name that the surface has now. */
    private FourierTable checked(FourierTable table, Plan plan) {
        Expansion expansion = plan.expansion();
        boolean same = table.patch().digest().equals(surface.identity().digest())
                && table.kind() == expansion.kind()
                && table.terms() == expansion.terms()
                && table.scale().equals(expansion.scale())
                && table.bandX().equals(plan.bandX())
                && table.bandY().equals(plan.bandY());
        if (!same) {
            throw new TableException("it is of another surface or plan");
        }
        return table.of(surface.identity());
    }

    /** Makes a Fourier table, with progress. */
    public FourierTable freshTable(Plan plan) {
        Expansion expansion = plan.expansion();
        try (Progress progress =
                Progress.start("Fourier tables of " + surface.identity().name(), expansion.terms())) {
            int[] done = {0};
            TableBuilder builder = new TableBuilder(surface.identity(), surface.levels(), terms -> {
                progress.step(terms - done[0]);
                done[0] = terms;
            });
            return builder.build(expansion, plan.bandX(), plan.bandY());
        }
    }

    private Optional<Path> file(String key, String ending) {
        String name = CacheEntry.name(surface.identity().digest(), Sha256.of(key), ending);
        return folder.open(warning).map(path -> path.resolve(name));
    }

    private <T> Optional<T> read(Path file, Function<Path, T> reader) {
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try {
            T kept = reader.apply(file);
            folder.used(file);
            return Optional.of(kept);
        } catch (TableException failure) {
            // Cleared by another process a moment ago: as if it had never been there.
            if (Files.exists(file)) {
                warning.accept("cached table is made again: " + failure.problem());
            }
            return Optional.empty();
        }
    }

    private void save(Path file, Consumer<Path> writer) {
        try {
            AtomicFile.writeFile(file, Overwrite.REPLACE, path -> {
                CacheFolder.makeOwnersOnly(path);
                writer.accept(path);
            });
            folder.shrink(folder.limit(warning), Optional.of(file));
        } catch (OutputException failure) {
            warning.accept("the table is not kept: " + failure.getMessage());
        }
    }
}
