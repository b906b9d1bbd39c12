package sunbeam.app.files.cache;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Function;
import sunbeam.app.cli.options.PatchOptions;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.ScanWarnings;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.BakeToken;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.method.TableSources;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTablesFile;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.TableBuilder;
import sunbeam.precompute.table.TableLabel;

/**
 * A loaded patch, and its tables in the cache folder, each under a hash of all that determines it; made where they are
 * missing. A file that is damaged or of something else is made again, with a word about it.
 *
 * @param surface the patch and the light that colors it
 * @param note told in one line each what takes longer than planned
 * @param warning told in one line each what goes wrong with the cache, or falls short
 */
public record DiffractionSetup(
        Patch patch, Surface surface, CacheFolder folder, Consumer<String> note, Consumer<String> warning) {
    /**
     * Loads the patch and says what the user should know of it.
     *
     * @param method whose preset may take files as the thesis does
     */
    public DiffractionSetup(PatchOptions options, Choices method, Environment environment, PrintWriter err) {
        this(loaded(options, method, environment, err), environment, err);
    }

    private static Patch loaded(PatchOptions options, Choices method, Environment environment, PrintWriter err) {
        BlobCache kept = BlobCache.of(environment, warning -> err.println(Messages.warning(warning)));
        try (Progress progress = Progress.start("Reading the heights", 1)) {
            Patch patch = options.load(method, kept::heights);
            progress.step(1);
            return patch;
        }
    }

    /** Takes a loaded patch and says what the user should know of it. */
    public DiffractionSetup(Patch patch, Environment environment, PrintWriter err) {
        this(
                patch,
                environment,
                note -> err.println(Messages.note(note)),
                warning -> err.println(Messages.warning(warning)));
        patch.notes().forEach(note -> err.println(Messages.note(patch.name() + ": " + note)));
    }

    /**
     * Takes a patch that is loaded already, whose warnings have been told.
     *
     * @param warning told in one line each what goes wrong with the cache, or falls short
     */
    public DiffractionSetup(Patch patch, Environment environment, Consumer<String> warning) {
        this(patch, environment, note -> {}, warning);
    }

    private DiffractionSetup(Patch patch, Environment environment, Consumer<String> note, Consumer<String> warning) {
        this(
                patch,
                Surface.of(patch).keeping(BlobCache.of(environment, warning)::numbers),
                CacheFolder.of(environment),
                note,
                warning);
    }

    /**
     * The choices that hold for this patch: no light sees farther than a scan reaches.
     *
     * @param err told in one line what is wrong with the patch, and what becomes of the coherence length
     */
    public Choices seen(Choices choices, PrintWriter err) {
        ScanLimit limit = ScanLimit.of(choices, patch);
        List<String> warnings = new ArrayList<>(patch.warnings());
        limit.line().ifPresent(line -> warnings.add(line.in(OptionOrigin.INSTANCE)));
        ScanWarnings.line(patch.name(), warnings, "inspect").ifPresent(err::println);
        return limit.choices();
    }

    /** The same in another light. */
    public DiffractionSetup lit(CieTable light) {
        return new DiffractionSetup(patch, surface.under(light), folder, note, warning);
    }

    public CieTable cie() {
        return surface.cie();
    }

    /** What a method's power and colors are held against, on this patch. */
    public ExactLight exact(Method method) {
        return method.exact(patch.heights()).area().over(patch.heights(), cie());
    }

    /**
     * What a method's shader reads, made now, layer by layer as it is asked for.
     *
     * @param bakers opens a baker by a shader, for tables that are made of colors
     * @throws SettingException when the method has no answer for the use
     */
    public ShaderTables freshTables(MethodPlan plan, MethodUse use, Function<ShaderTables, ColorBaker> bakers) {
        return freshTables(plan, use, bakers, warning);
    }

    /** @param shortfall told where a table misses its tolerance */
    private ShaderTables freshTables(
            MethodPlan plan, MethodUse use, Function<ShaderTables, ColorBaker> bakers, Consumer<String> shortfall) {
        requireAnswer(plan, use);
        return plan.tables(use, sources(bakers, shortfall));
    }

    /**
     * What tables are made of.
     *
     * @param bakers opens a baker by a shader
     * @param shortfall receives a line for each table that misses its tolerance
     */
    public TableSources sources(Function<ShaderTables, ColorBaker> bakers, Consumer<String> shortfall) {
        DiffractionSetup setup = this;
        return new TableSources() {
            @Override
            public FourierTable fourier(Plan plan) {
                return fourierTable(plan);
            }

            @Override
            public ShaderTables tables(MethodPlan plan) {
                return setup.tables(plan, MethodUse.COLOR, bakers);
            }

            @Override
            public ColorBaker baker(ShaderTables tables) {
                return bakers.apply(tables);
            }

            @Override
            public BakeToken progress(long samples) {
                return Progress.start("Colors of " + surface.identity().name(), samples);
            }

            @Override
            public boolean hasTiles() {
                return folder.open(warning).isPresent()
                        && folder.entries().stream()
                                .anyMatch(entry ->
                                        entry.isTilesOf(surface.identity().digest()));
            }

            @Override
            public boolean hasTiles(ColorTablePlan plan) {
                return setup.hasTiles(plan);
            }

            @Override
            public CachedTiles tiles(ColorTablePlan plan) {
                return setup.tiles(plan);
            }

            @Override
            public ValidatedTable.Told told() {
                return new ValidatedTable.Told(note, shortfall);
            }
        };
    }

    /** As {@link #tables(MethodPlan, MethodUse, Function, DoubleConsumer)}, without progress. */
    public ShaderTables tables(MethodPlan plan, MethodUse use, Function<ShaderTables, ColorBaker> bakers) {
        return tables(plan, use, bakers, share -> {});
    }

    /**
     * What a method's shader reads, as it lies in the cache. Nothing is computed where it is there, and layer by layer, on
     * the way to the file, where it is not. Without a cache folder, layers are computed when they are asked for. A table that misses
     * its tolerance is not kept, so that each run tells of it.
     *
     * @param bakers opens a baker by a shader, for tables that are made of colors
     * @param progress told before each layer that is made the share that is done; goes on when it returns
     * @throws SettingException when the method has no answer for the use
     */
    public ShaderTables tables(
            MethodPlan plan, MethodUse use, Function<ShaderTables, ColorBaker> bakers, DoubleConsumer progress) {
        requireAnswer(plan, use);
        String key = "shader tables " + ShaderTablesFile.VERSION + "|" + plan.key(use);
        Optional<Path> file = file(key, CacheEntry.SHADER);
        if (file.isEmpty() || plan.memory().textureBytes() > folder.largest()) {
            return freshTables(plan, use, bakers).preceded(progress);
        }
        Function<Path, ShaderTables> reader = path -> ShaderTablesFile.read(path, key);
        return folder.read(file.get(), reader, warning).orElseGet(() -> {
            TableLabel label = label(plan);
            List<String> shortfalls = new ArrayList<>();
            ShaderTables made = freshTables(plan, use, bakers, shortfalls::add).preceded(progress);
            shortfalls.forEach(warning);
            if (!shortfalls.isEmpty()) {
                return made;
            }
            TableLabel tried = made.trial().isEmpty()
                    ? label
                    : new TableLabel(label.patch(), "table in " + made.trial() + "; planned as " + label.what());
            folder.save(file.get(), path -> ShaderTablesFile.write(path, key, tried, made), warning);
            // Again from the file, so that no more than one layer at a time need be in memory.
            return folder.read(file.get(), reader, warning).orElse(made);
        });
    }

    private TableLabel label(MethodPlan plan) {
        return TableLabel.of(surface.identity().name(), surface.identity().digest(), plan.summary());
    }

    private static String tilesKey(ColorTablePlan plan) {
        return String.join(
                "|",
                "tiles " + ShaderTablesFile.VERSION,
                plan.key(MethodUse.COLOR),
                String.valueOf(plan.tolerance()),
                plan.spectrum().map(Plan::key).orElse(""));
    }

    /** Whether there is a file of such tiles; it may be damaged. */
    public boolean hasTiles(ColorTablePlan plan) {
        return file(tilesKey(plan), CacheEntry.TILES).filter(Files::exists).isPresent();
    }

    /** Tiles of a plan's levels of colors that are kept for later runs; to be closed by the caller. None without a cache folder. */
    public CachedTiles tiles(ColorTablePlan plan) {
        String key = tilesKey(plan);
        TableLabel label = label(plan);
        Optional<Path> file = file(key, CacheEntry.TILES);
        if (file.isEmpty()) {
            return CachedTiles.NONE;
        }
        Path path = file.get();
        long most = folder.limit();
        CachedTiles tiles = TileFile.of(
                path,
                key,
                plan.table().numbers(),
                label,
                folder.largest(),
                warning,
                () -> folder.shrink(most, Optional.of(path)));
        folder.used(path);
        folder.shrink(most, file);
        return tiles;
    }

    /** The Fourier table that a plan needs. It is made in less time than colors take that need it, and not kept. */
    public FourierTable fourierTable(Plan plan) {
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

    private static void requireAnswer(MethodPlan plan, MethodUse use) {
        if (!plan.answers(use)) {
            throw withoutPower();
        }
    }

    /** What is said of a method that knows colors alone, where power at a wavelength is asked for. */
    public static SettingException withoutPower() {
        return new SettingException(
                Methods.METHOD,
                "has colors, but no power at a wavelength; leave out the column wavelength, or use another method");
    }
}
