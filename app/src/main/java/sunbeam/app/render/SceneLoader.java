package sunbeam.app.render;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import jrtr.GraphicsException;
import jrtr.gl.RenderContext;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.render.SceneData.ReflectanceComponent;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.terminal.Environment;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.method.ColorTablePlan;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings.FresnelFactor;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.ShaderTables.MethodUse;
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
     * Loads a scene's parts, one per patch and reflectance component, ordered by patch; the scene's picture is their sum.
     *
     * @param shape the scene's {@link #shape}; may still be loading, since the patches mostly use one processor
     * @throws sunbeam.precompute.files.InputException if mesh, texture, map, index, patch or its descriptor cannot be used
     * @throws sunbeam.precompute.setting.SettingException if a choice about patch or method cannot be used; names its source
     */
    public List<SceneData> parts(Scene scene, BackgroundTask<SceneShape> shape) {
        try {
            List<Optional<ReflectanceComponent>> parts = reflectanceComponents(scene);
            return withTables(scene, shape::get, patches(scene), parts, share -> {});
        } finally {
            shape.settle();
        }
    }

    /** Loads a scene without diffraction; computes the visible sky in the background if the scene needs it. */
    public SceneShape shape(Scene scene) {
        Mesh mesh = mesh(scene);
        return new SceneShape(mesh, sky(scene, mesh), bodies(scene));
    }

    /** Loads a scene's parts, reusing data of unchanged settings without checking files; {@code progress} gets shares, 0 to 1. */
    public List<SceneData> parts(Scene scene, List<SceneData> previous, DoubleConsumer progress) {
        SceneData first = previous.get(0);
        if (first.suits(scene)) {
            return previous.stream().map(part -> part.with(scene)).toList();
        }
        Scene before = first.scene();
        boolean sameMesh = before.mesh().equals(scene.mesh());
        boolean samePlaces = before.patches().equals(scene.patches());
        Mesh mesh = sameMesh ? first.mesh() : mesh(scene);
        SceneShape shape = new SceneShape(
                mesh,
                sameMesh ? first.shape().sky() : sky(scene, mesh),
                samePlaces && before.sharesBody(scene) ? first.shape().bodies() : bodies(scene));
        boolean samePatches =
                samePlaces && before.method().isThesis() == scene.method().isThesis();
        boolean sameMethod = before.method().method().equals(scene.method().method())
                && before.method().light().equals(scene.method().light())
                && before.tabulatedSlopes() == scene.tabulatedSlopes();
        if (samePatches && sameMethod && before.sharesReflectance(scene)) {
            return previous.stream().map(part -> part.with(scene, shape)).toList();
        }
        List<Patch> patches = samePatches ? SceneData.ofRegions(previous, SceneData::patch) : patches(scene);
        progress.accept(HEIGHTS_READ);
        return withTables(scene, () -> shape, patches, reflectanceComponents(scene), progress);
    }

    private List<SceneData> withTables(
            Scene scene,
            Supplier<SceneShape> shape,
            List<Patch> patches,
            List<Optional<ReflectanceComponent>> parts,
            DoubleConsumer progress) {
        List<SceneData> loaded = new ArrayList<>();
        int count = patches.size() * parts.size();
        for (int region = 0; region < patches.size(); region++) {
            Patch patch = patches.get(region);
            SceneData.patchRemarks(scene, patch).forEach(patchRemark);
            for (Optional<ReflectanceComponent> part : parts) {
                int before = loaded.size();
                DoubleConsumer progressOfAll =
                        share -> progress.accept(HEIGHTS_READ + (1 - HEIGHTS_READ) * (before + share) / count);
                loaded.add(withTables(scene, shape, region, patch, part, progressOfAll));
            }
            warnOfSteps(loaded.get(loaded.size() - 1));
        }
        return List.copyOf(loaded);
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
        if (scene.lights().stream().anyMatch(light -> scene.deviation(light) > 0)
                && scene.method().method() instanceof TableMethod table
                && table.area().average() == Average.COHERENT) {
            throw scene.method()
                    .choices()
                    .complaint(
                            AVERAGE,
                            "coherent has no color of a light with an angularDiameter; give ensemble, or method full");
        }
    }

    private Mesh mesh(Scene scene) {
        MeshSource.Loaded read = scene.mesh().load();
        read.warnings().forEach(warning);
        return read.mesh();
    }

    private Supplier<SkyVisibility> sky(Scene scene, Mesh mesh) {
        Supplier<SkyVisibility> computed = () -> SkyVisibility.of(mesh, cache);
        return scene.occludesSky() ? BackgroundTask.start(computed)::get : computed;
    }

    private List<Body> bodies(Scene scene) {
        String directions = scene.get(SceneSettings.ORIENTATION_MAP);
        Body body = Body.load(scene.get(SceneSettings.TEXTURE), scene.effectiveScales(), directions, cache);
        PatchAtlas atlas = scene.patches();
        BodyTexture map = Body.patches(atlas.map(), atlas.colors());
        return atlas.regions().stream()
                .map(region -> body.with(map, region.color().rgb()))
                .toList();
    }

    private List<Patch> patches(Scene scene) {
        return scene.patches().regions().stream()
                .map(region -> region.patch().raw(scene.method().isThesis()))
                .map(request -> PatchLoader.load(request, cache::heights))
                .toList();
    }

    /** Plans for every pair of directions, since light and camera may move. */
    private SceneData withTables(
            Scene scene,
            Supplier<SceneShape> shape,
            int region,
            Patch patch,
            Optional<ReflectanceComponent> part,
            DoubleConsumer progress) {
        Choices choices = scene.method().choices();
        DiffractionSetup setup = new DiffractionSetup(patch, environment, warning).withLight(LightTable.of(choices));
        Surface surface = part.map(
                        found -> setup.surface().withLight(found.reflection().cie()))
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
        return new SceneData(scene, shape.get(), region, patch, method, tables, bakers, part);
    }

    /**
     * Data of a scene without its diffraction, which takes longer to load.
     *
     * @param sky visible share of the sky; computed on first use
     * @param bodies texture, scales and orientations of the mesh, each with the area of one patch
     */
    public record SceneShape(Mesh mesh, Supplier<SkyVisibility> sky, List<Body> bodies) {}

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
            List<SceneSession> sessions = new ArrayList<>();
            try {
                sessions.add(new SceneSession(context, scene, shape.get()));
                sessions.get(0).update(parts.get().get(0));
                parts.get().stream().skip(1).forEach(part -> sessions.add(new SceneSession(context, part)));
                return List.copyOf(sessions);
            } catch (RuntimeException | OutOfMemoryError failure) {
                sessions.forEach(SceneSession::close);
                throw failure;
            }
        }

        @Override
        public void close() {
            parts.settle();
        }
    }
}
