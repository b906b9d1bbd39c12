package sunbeam.app.gpu.colors;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Function;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.cache.CacheFolder;
import sunbeam.app.files.cache.TileFile;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.MethodPlan.TableSources;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.ShaderTablesFile;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.TableLabel;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.work.Progress;

/**
 * Loaded patch and the cache of its tables, each under a hash of all that determines it; damaged ones are made again.
 *
 * @param warning receives a line for each failure of the cache
 * @param diagnostics receives a line for each step that takes longer than planned, and each table that misses its tolerance
 */
public record DiffractionSetup(
        Patch patch,
        Surface surface,
        CacheFolder folder,
        Consumer<String> warning,
        ValidatedTable.Diagnostics diagnostics,
        ProgressDisplay progress)
        implements TableSources {
    // Version of the colors that bakers compute, in the key of cached tiles.
    private static final int BAKING = 2;

    /** Prints the patch's notes. */
    public DiffractionSetup(Patch patch, Environment environment, PrintWriter err) {
        this(
                patch,
                environment,
                note -> err.println(Messages.note(note)),
                warning -> err.println(Messages.warning(warning)));
        patch.notes().forEach(note -> err.println(Messages.note(patch.name() + ": " + note)));
    }

    /** Does not print the patch's notes. */
    public DiffractionSetup(Patch patch, Environment environment, Consumer<String> warning) {
        this(patch, environment, note -> {}, warning);
    }

    private DiffractionSetup(Patch patch, Environment environment, Consumer<String> note, Consumer<String> warning) {
        this(
                patch,
                Surface.of(patch).withStatistics(BlobCache.of(environment, warning)::numbers),
                CacheFolder.of(environment),
                warning,
                new ValidatedTable.Diagnostics(note, warning),
                environment.progress());
    }

    /** Limits the coherence length to the scan's shorter side, and prints the patch's warnings. */
    public Choices limitToScan(Choices choices, PrintWriter err) {
        ScanLimit limit = ScanLimit.of(choices, patch);
        List<String> warnings = new ArrayList<>(patch.warnings());
        limit.line().ifPresent(line -> warnings.add(line.in(OptionOrigin.INSTANCE)));
        Messages.scanWarning(patch.name(), warnings, "inspect --explain").ifPresent(err::println);
        return limit.choices();
    }

    public DiffractionSetup withLight(CieTable light) {
        return new DiffractionSetup(patch, surface.withLight(light), folder, warning, diagnostics, progress);
    }

    public CieTable cie() {
        return surface.cie();
    }

    public ExactLight exact(Method method) {
        return method.referenceMethod(patch.heights()).light(patch.heights(), cie());
    }

    /** Returns uncached tables, computed when read; throws {@link SettingException} if the method does not support the use. */
    public ShaderTables freshTables(MethodPlan plan, MethodUse use) {
        requireUse(plan, use);
        return plan.tables(use, this);
    }

    /** Returns this setup with another receiver of a line for each table that misses its tolerance. */
    public DiffractionSetup withShortfall(Consumer<String> shortfall) {
        ValidatedTable.Diagnostics other = new ValidatedTable.Diagnostics(diagnostics.note(), shortfall);
        return new DiffractionSetup(patch, surface, folder, warning, other, progress);
    }

    @Override
    public ColorBaker baker(ShaderTables tables) {
        return GpuBaker.of(tables);
    }

    @Override
    public Progress progress(long samples) {
        return progress.start("Colors of " + surface.name(), samples);
    }

    @Override
    public boolean hasTiles() {
        return folder.open(warning).isPresent() && folder.hasTiles(surface.digest());
    }

    @Override
    public boolean hasTiles(ColorTablePlan plan) {
        return file(tilesKey(plan), CacheFolder.Entry.TILES)
                .filter(Files::exists)
                .isPresent();
    }

    @Override
    public CachedTiles tiles(ColorTablePlan plan) {
        String key = tilesKey(plan);
        TableLabel label = label(plan.plan());
        return file(key, CacheFolder.Entry.TILES)
                .map(path -> TileFile.of(folder, path, key, plan.table().numbers(), label, warning))
                .orElse(CachedTiles.NONE);
    }

    @Override
    public ShaderTables tables(MethodPlan plan) {
        return tables(plan, MethodUse.COLOR);
    }

    public ShaderTables tables(MethodPlan plan, MethodUse use) {
        return tables(plan, use, share -> {});
    }

    /**
     * Returns shader tables from the cache, or makes and caches them layer by layer; without a cache folder when layers are read. A table
     * that misses its tolerance is not cached, so that each run warns of it.
     *
     * @param progress receives the share, 0..1, before each layer that is made
     * @throws SettingException if the method does not support the use
     */
    public ShaderTables tables(MethodPlan plan, MethodUse use, DoubleConsumer progress) {
        requireUse(plan, use);
        String key = "shader tables " + ShaderTablesFile.VERSION + "|" + plan.key(use);
        Optional<Path> file = file(key, CacheFolder.Entry.SHADER);
        if (file.isEmpty() || plan.memory().textureBytes() > folder.largest()) {
            return freshTables(plan, use).preceded(progress);
        }
        Function<Path, ShaderTables> reader = path -> ShaderTablesFile.read(path, key);
        return folder.read(file.get(), reader, warning).orElseGet(() -> {
            List<String> shortfalls = new ArrayList<>();
            ShaderTables made = plan.tables(use, withShortfall(shortfalls::add)).preceded(progress);
            shortfalls.forEach(diagnostics.shortfall());
            if (!shortfalls.isEmpty()) {
                return made;
            }
            TableLabel planned = label(plan);
            TableLabel label = made.trial().isEmpty()
                    ? planned
                    : new TableLabel(planned.patch(), "table in " + made.trial() + "; planned as " + planned.what());
            folder.save(file.get(), path -> ShaderTablesFile.write(path, key, label, made), warning);
            // Mapped, so that layers do not stay in the heap.
            return folder.read(file.get(), reader, warning).orElse(made);
        });
    }

    private TableLabel label(MethodPlan plan) {
        return TableLabel.of(surface.name(), surface.digest(), plan.summary());
    }

    private static String tilesKey(ColorTablePlan plan) {
        return "tiles " + BAKING + "|" + ShaderTablesFile.VERSION + "|"
                + plan.plan().key(MethodUse.COLOR) + "|" + plan.tolerance() + "|"
                + plan.spectrum().map(SpectrumPlan::key).orElse("");
    }

    /** Not cached, because the colors that need it take longer. */
    @Override
    public FourierTable fourier(SpectrumPlan plan) {
        try (Progress task = progress.start(
                "Fourier tables of " + surface.name(), plan.expansion().terms())) {
            return plan.fourierTable(surface.map(), task::step);
        }
    }

    private Optional<Path> file(String key, String ending) {
        return folder.file(surface.digest(), key, ending, warning);
    }

    private static void requireUse(MethodPlan plan, MethodUse use) {
        if (!plan.uses().contains(use)) {
            throw withoutPower();
        }
    }

    /** Complaint about a method that has colors, but no power. */
    public static SettingException withoutPower() {
        return new SettingException(
                Methods.METHOD,
                "has colors, but no power at a wavelength, which evaluate and a list's column wavelength need;"
                        + " use full, nmm, pq or reference");
    }
}
