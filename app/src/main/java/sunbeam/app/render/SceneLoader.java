package sunbeam.app.render;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.PRESET;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.render.SceneData.ReflectanceComponent;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.terminal.Environment;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.FresnelFactor;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;

/** Loads the data of scenes. Needs no OpenGL and may run on any thread; may take seconds. */
public final class SceneLoader {
    // Finished shares: of the whole when heights are read, of the rest when a part's method is planned.
    private static final double HEIGHTS_READ = 0.2;
    private static final double METHOD_PLANNED = 0.4;

    private final Environment environment;
    private final Consumer<String> warning;
    private final Consumer<String> patchRemark;
    private final BlobCache cache;

    /** @param warning accepts warnings about files, one line each */
    public SceneLoader(Environment environment, Consumer<String> warning) {
        this(environment, warning, warning);
    }

    /** @param patchRemark accepts {@link SceneData#patchRemarks} */
    public SceneLoader(Environment environment, Consumer<String> warning, Consumer<String> patchRemark) {
        this.environment = environment;
        this.warning = warning;
        this.patchRemark = patchRemark;
        this.cache = BlobCache.of(environment, warning);
    }

    /**
     * Loads a scene's parts, one per look, patch and reflectance component, in this order; the scene's picture is made of them.
     *
     * @param shape the scene's {@link #shape}; may still be loading, since the patches mostly use one processor
     * @throws sunbeam.precompute.files.InputException if mesh, texture, map, index, patch or its descriptor cannot be used
     * @throws sunbeam.precompute.setting.SettingException if a choice about patch or method cannot be used; names its source
     */
    public List<SceneData> parts(Scene scene, BackgroundTask<SceneShape> shape) {
        try {
            return withTables(scene, shape::get, List.of(), share -> {});
        } finally {
            shape.settle();
        }
    }

    /** Loads a scene without diffraction; computes the visible sky in the background if the scene needs it. */
    public SceneShape shape(Scene scene) {
        return SceneShape.load(scene, null, scene, cache, warning);
    }

    /** Loads a scene's parts, reusing data of unchanged settings without checking files; {@code progress} gets shares, 0 to 1. */
    public List<SceneData> parts(Scene scene, List<SceneData> previous, DoubleConsumer progress) {
        SceneData first = previous.get(0);
        Scene before = first.scene();
        if (SceneSharing.sharesParts(before, scene)) {
            return previous.stream().map(part -> part.with(scene)).toList();
        }
        SceneShape shape = SceneShape.load(scene, first.shape(), before, cache, warning);
        return withTables(scene, () -> shape, previous, progress);
    }

    private List<SceneData> withTables(
            Scene scene, Supplier<SceneShape> shape, List<SceneData> previous, DoubleConsumer progress) {
        List<Scene> looks = scene.looks().stream().distinct().map(scene::at).toList();
        Map<PatchRequest, Patch> patches = new HashMap<>();
        previous.forEach(part -> patches.put(heights(part.scene(), part.region()), part.patch()));
        List<PartInput> inputs = new ArrayList<>();
        for (Scene look : looks) {
            List<Optional<ReflectanceComponent>> components = reflectanceComponents(look);
            for (int region = 0; region < look.patches().regions().size(); region++) {
                Patch patch = patches.computeIfAbsent(
                        heights(look, region), request -> PatchLoader.load(request, cache::heights));
                for (Optional<ReflectanceComponent> component : components) {
                    inputs.add(new PartInput(look, region, patch, component));
                }
            }
        }
        progress.accept(HEIGHTS_READ);
        List<SceneData> loaded = new ArrayList<>();
        Set<Patch> remarked = new HashSet<>();
        for (PartInput input : inputs) {
            int done = loaded.size();
            DoubleConsumer progressOfAll =
                    share -> progress.accept(HEIGHTS_READ + (1 - HEIGHTS_READ) * (done + share) / inputs.size());
            Optional<SceneData> equal = Stream.concat(loaded.stream(), previous.stream())
                    .filter(input::sharesTables)
                    .findFirst();
            boolean isNew = equal.isEmpty() && remarked.add(input.patch);
            if (isNew) {
                SceneData.patchRemarks(scene, input.patch).forEach(patchRemark);
            }
            loaded.add(equal.map(other -> input.with(other, shape.get()))
                    .orElseGet(() -> withTables(input, shape, progressOfAll)));
            if (isNew) {
                warnOfSteps(loaded.get(done));
            }
        }
        return List.copyOf(loaded);
    }

    private static PatchRequest heights(Scene look, int region) {
        return look.patches().regions().get(region).patch().raw(look.method().isThesis());
    }

    /** Input of a part's tables. */
    private record PartInput(Scene look, int region, Patch patch, Optional<ReflectanceComponent> component) {
        /** True if another part has the same tables; patches are compared as objects. */
        boolean sharesTables(SceneData other) {
            Scene before = other.scene();
            return SceneSharing.isSame(other.patch(), patch)
                    && before.method().method().equals(look.method().method())
                    && before.method().isThesis() == look.method().isThesis()
                    && before.method().light().equals(look.method().light())
                    && before.tabulatedSlopes() == look.tabulatedSlopes()
                    && SceneSharing.sharesReflectance(before, look)
                    && component
                            .map(ReflectanceComponent::identity)
                            .equals(other.reflectanceComponent().map(ReflectanceComponent::identity));
        }

        SceneData with(SceneData tables, SceneShape shape) {
            return new SceneData(
                    look,
                    shape,
                    region,
                    patch,
                    tables.method(),
                    tables.tables(),
                    tables.bakers(),
                    tables.reflectanceComponent());
        }
    }

    private void warnOfSteps(SceneData data) {
        double slopes = data.scene().slopeDeviation();
        boolean isTableSmooth =
                data.bakers().stream().anyMatch(bakers -> bakers.table().slopeDeviation() == 0);
        if (slopes > 0 && isTableSmooth) {
            warning.accept(Text.format(
                    "%s: roughness %.2g deg: method table averages over slopes from 1 deg on, of an ensemble average;"
                            + " here highlights may have edges where their brightness jumps. Use 0 deg, 1 deg or more, or method full",
                    data.patch().name(), Math.toDegrees(Math.atan(slopes))));
        }
    }

    private static List<Optional<ReflectanceComponent>> reflectanceComponents(Scene scene) {
        if (!scene.get(SceneSettings.INDEX).isByWavelength()) {
            return List.of(Optional.empty());
        }
        Choices method = scene.method().choices();
        FresnelFactor.requireFor(scene.get(SceneSettings.INDEX).values(), method);
        return ReflectanceComponent.of(scene.get(SceneSettings.INDEX).values(), LightTable.of(method)).stream()
                .map(Optional::of)
                .toList();
    }

    /** Only ensemble averages have levels for a wide light. */
    private static void requireEnsemble(Scene scene) {
        Choices choices = scene.method().choices();
        if (!scene.hasEnvironment() && scene.get(SceneSettings.BACKGROUND).isEmpty()) {
            throw scene.settings()
                    .complaint(SceneSettings.BACKGROUND, "is the environment, and the scene has none; give #rrggbb");
        }
        if (scene.hasEnvironment() && scene.method().isThesis()) {
            throw choices.complaint(
                    PRESET,
                    "thesis has one light and no environment; leave it out, or set ",
                    SceneSettings.ENVIRONMENT,
                    " none");
        }
        boolean isCoherentTable =
                scene.method().isTable() && scene.method().area().average() == Average.COHERENT;
        if (isCoherentTable && scene.hasEnvironment()) {
            throw choices.complaint(
                    AVERAGE, "coherent has no color of an environment's wide lights; give ensemble, or method full");
        }
        if (isCoherentTable && scene.lights().stream().anyMatch(light -> scene.deviation(light) > 0)) {
            throw choices.complaint(
                    AVERAGE, "coherent has no color of a light with an angularDiameter; give ensemble, or method full");
        }
    }

    /** Plans for every pair of directions, since light and camera may move. */
    private SceneData withTables(PartInput input, Supplier<SceneShape> shape, DoubleConsumer progress) {
        Scene scene = input.look;
        Patch patch = input.patch;
        Choices choices = scene.method().choices();
        DiffractionSetup setup = new DiffractionSetup(patch, environment, warning).withLight(LightTable.of(choices));
        Surface surface = input.component
                .map(found -> setup.surface().withLight(found.reflection().cie()))
                .orElse(setup.surface());
        MethodPlan planned =
                choices.located(() -> scene.method().seeing(patch).method().plan(surface, VisibleRange.all()));
        requireEnsemble(scene);
        progress.accept(METHOD_PLANNED);
        DoubleConsumer progressOfTables = share -> progress.accept(METHOD_PLANNED + (1 - METHOD_PLANNED) * share);
        Optional<ColorTablePlan> levels = planned.colorTable().map(plan -> plan.onRelief(scene.slopeDeviation()));
        MethodPlan method = levels.map(ColorTablePlan::plan).orElse(planned);
        ShaderTables made = levels.isPresent()
                ? setup.freshTables(method, MethodUse.COLOR)
                : setup.tables(method, MethodUse.COLOR, progressOfTables);
        Choices limited = scene.method().seeing(patch).choices();
        ShaderTables tables = scene.effectiveEnergy()
                .divisor(patch.heights(), scene.get(SceneSettings.INDEX).values(), limited)
                .map(divisor -> divisor.applyTo(made, setup.cie()))
                .orElse(made);
        Optional<LevelBakers> bakers = levels.map(plan ->
                new LevelBakers(plan, setup.withShortfall(line -> warning.accept(patch.name() + ": " + line))));
        return new SceneData(scene, shape.get(), input.region, patch, method, tables, bakers, input.component);
    }

    /** Loads a scene in the background while OpenGL starts, and uploads its shape and parts as they are loaded. */
    public static final class LoadingScene implements AutoCloseable {
        private final Scene scene;
        private final BackgroundTask<SceneShape> shape;
        private final BackgroundTask<List<SceneData>> parts;

        public LoadingScene(SceneLoader loader, Scene scene) {
            this.scene = scene;
            this.shape = BackgroundTask.start(() -> loader.shape(scene));
            this.parts = BackgroundTask.start(() -> loader.parts(scene, shape));
        }

        /** Creates a context for the upload. A failure of loading is reported first, since the user can fix it. */
        public RenderContext offscreen() {
            try {
                return RenderContext.offscreen();
            } catch (GraphicsException failure) {
                parts.get();
                throw failure;
            }
        }

        /** Uploads each part as a session, which the caller closes. Throws {@link GraphicsException} if the device has no room. */
        public List<SceneSession> upload(RenderContext context) {
            SceneSession first = new SceneSession(context, scene, shape.get());
            return Resource.orClose(() -> SceneSession.all(first, parts.get()), first::close);
        }

        @Override
        public void close() {
            parts.settle();
        }
    }
}
