package sunbeam.app.files.cache;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.terminal.ScanWarnings;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorSources;
import sunbeam.precompute.colortable.KeptPages;
import sunbeam.precompute.method.LevelledPlan;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;

/** A loaded patch, and its tables from the cache or anew. */
public final class DiffractionSetup {
    private final Patch patch;
    private final Surface surface;
    private final TableStore store;

    /**
     * Loads the patch and says what the user should know of it.
     *
     * @param method whose preset may take files as the thesis does
     */
    public DiffractionSetup(PatchOptions options, Choices method, Environment environment, PrintWriter err) {
        this(loaded(options, method), environment, err);
    }

    private static Patch loaded(PatchOptions options, Choices method) {
        try (Progress progress = Progress.start("Reading the heights", 1)) {
            Patch patch = options.load(method);
            progress.step(1);
            return patch;
        }
    }

    /** Takes a loaded patch and says what the user should know of it. */
    public DiffractionSetup(Patch patch, Environment environment, PrintWriter err) {
        this(
                patch,
                environment,
                note -> {
                    err.println(Messages.note(note));
                    err.flush();
                },
                warning -> {
                    err.println(Messages.warning(warning));
                    err.flush();
                });
        patch.notes().forEach(note -> err.println(Messages.note(patch.name() + ": " + note)));
        err.flush();
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
        this.patch = patch;
        this.surface = Surface.of(patch);
        this.store = new TableStore(surface, environment, note, warning);
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
        err.flush();
        return limit.choices();
    }

    public Patch patch() {
        return patch;
    }

    /** The patch and the light that colors it. */
    public Surface surface() {
        return surface;
    }

    public CieTable cie() {
        return surface.cie();
    }

    /** What a method's power and colors are held against, on this patch. */
    public ExactLight exact(Method method) {
        return method.exact(patch.heights()).area().over(patch.heights(), cie());
    }

    /** The Fourier table that a plan needs, from the cache where it is there. */
    public FourierTable table(Plan plan) {
        return store.table(plan);
    }

    /** As {@link #table(Plan)}; {@code saving} takes what keeps one for later runs that was made now. */
    public FourierTable table(Plan plan, Consumer<Runnable> saving) {
        return store.table(plan, saving);
    }

    /**
     * What a method's shader reads, made now, layer by layer as it is asked for.
     *
     * @param colors who evaluates shaders, for tables that are made of colors
     * @throws SettingException when the method has no answer for the use
     */
    public ShaderTables freshTables(MethodPlan plan, MethodUse use, ColorSources colors) {
        requireAnswer(plan, use);
        return store.freshTables(plan, use, colors);
    }

    /**
     * What a method's shader reads, from the cache where it is there.
     *
     * @param colors who evaluates shaders, for tables that are made of colors
     * @throws SettingException when the method has no answer for the use
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
        requireAnswer(plan, use);
        return store.tables(plan, use, colors, progress);
    }

    /** Whether there may be such pages. */
    public boolean hasPages(LevelledPlan plan) {
        return store.hasPages(plan);
    }

    /** Pages of a plan's levels of colors that are kept for later runs; to be closed by the caller. */
    public KeptPages pages(LevelledPlan plan) {
        return store.pages(plan);
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
