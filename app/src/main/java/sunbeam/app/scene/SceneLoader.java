package sunbeam.app.scene;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.input.IndexFile;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.gpu.colours.LevelSources;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.mesh.ReadMesh;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.scene.texture.BodyTextures;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** Loads what a scene names. Needs no OpenGL and may run on any thread; may take seconds. */
public final class SceneLoader {
    private final Environment environment;
    private final Consumer<String> warning;

    /** @param warning told in one line each what the user should know of the files */
    public SceneLoader(Environment environment, Consumer<String> warning) {
        this.environment = environment;
        this.warning = warning;
    }

    /**
     * Loads everything.
     *
     * @throws sunbeam.app.scene.mesh.MeshException if the mesh cannot be used
     * @throws sunbeam.app.files.input.InputException if the texture cannot be used
     * @throws sunbeam.precompute.patch.PatchException if the patch cannot be used
     * @throws sunbeam.precompute.json.JsonException if its descriptor cannot be used
     * @throws sunbeam.precompute.setting.SettingException if what was chosen of patch or method cannot be used; names the place
     *     where it was chosen
     */
    public SceneData load(Scene scene) {
        requireWhole(scene);
        return parts(scene).get(0);
    }

    /**
     * Loads everything, for each part of the skin's diffracted light: pictures of a skin with an index by wavelength are sums.
     *
     * @return one, or those of an index by wavelength
     * @throws sunbeam.app.files.input.InputException if texture or index cannot be used
     */
    public List<SceneData> parts(Scene scene) {
        List<Optional<SkinPart>> parts = skinParts(scene);
        Mesh mesh = mesh(scene);
        BodyTexture body = BodyTextures.load(scene.texture());
        Patch patch = patch(scene);
        tellLimit(scene, patch);
        return parts.stream()
                .map(part -> withTables(scene, mesh, body, patch, part))
                .toList();
    }

    private static List<Optional<SkinPart>> skinParts(Scene scene) {
        if (!scene.index().isByWavelength()) {
            return List.of(Optional.empty());
        }
        RefractiveIndex index = IndexFile.read(Path.of(scene.index().file()));
        return SkinPart.of(index, CieTable.load()).stream().map(Optional::of).toList();
    }

    private static void requireWhole(Scene scene) {
        if (scene.index().isByWavelength()) {
            throw SkinPart.refusal(scene.index().file());
        }
    }

    /** As {@link #load(Scene)}, keeping what has not changed; files are not looked at again. */
    public SceneData load(Scene scene, SceneData previous) {
        requireWhole(scene);
        Scene before = previous.scene();
        Mesh mesh = before.mesh().equals(scene.mesh()) ? previous.mesh() : mesh(scene);
        BodyTexture body =
                before.texture().equals(scene.texture()) ? previous.body() : BodyTextures.load(scene.texture());
        boolean samePatch = before.patch().equals(scene.patch())
                && before.method().isThesis() == scene.method().isThesis();
        boolean sameMethod = before.method().method().equals(scene.method().method());
        if (samePatch && sameMethod) {
            return new SceneData(
                    scene, mesh, previous.patch(), previous.method(), previous.tables(), previous.levels(), body);
        }
        Patch patch = samePatch ? previous.patch() : patch(scene);
        tellLimit(scene, patch);
        return withTables(scene, mesh, body, patch, Optional.empty());
    }

    /** A scene that is loaded already, by another method; what is to be said of the patch has been said. */
    public SceneData preview(Scene scene, SceneData loaded) {
        return withTables(scene, loaded.mesh(), loaded.body(), loaded.patch(), loaded.part());
    }

    private Mesh mesh(Scene scene) {
        ReadMesh read = MeshSource.load(scene.mesh(), Path.of(""));
        read.warnings().forEach(warning);
        return read.mesh();
    }

    private Patch patch(Scene scene) {
        Patch patch = PatchOptions.load(scene.patch().raw(scene.method().isThesis()));
        patch.notes().forEach(line -> warning.accept(patch.name() + ": " + line));
        patch.warnings().forEach(line -> warning.accept(patch.name() + ": " + line));
        return patch;
    }

    private void tellLimit(Scene scene, Patch patch) {
        Choices choices = scene.method().choices();
        ScanLimit.of(choices, patch)
                .line()
                .ifPresent(line -> warning.accept(patch.name() + ": " + line.in(choices.origin(COHERENCE_LENGTH))));
    }

    /** Light and camera may move at any time, so that the plan holds for every pair of directions. */
    private SceneData withTables(Scene scene, Mesh mesh, BodyTexture body, Patch patch, Optional<SkinPart> part) {
        DiffractionSetup setup = new DiffractionSetup(patch, environment, warning);
        Surface surface = part.map(
                        found -> setup.surface().under(found.reflection().cie()))
                .orElse(setup.surface());
        Choices choices = scene.method().choices();
        MethodPlan method =
                choices.located(() -> scene.method().seeing(patch).method().plan(surface, VisibleRange.all()));
        Optional<LevelSources> levels = method.levelled().map(plan -> new LevelsOfSetup(setup, plan, surface.cie()));
        ShaderTables tables = levels.isPresent()
                ? setup.freshTables(method, MethodUse.COLOUR, GpuColours::of)
                : setup.tables(method, MethodUse.COLOUR, GpuColours::of);
        return new SceneData(scene, mesh, patch, method, tables, levels, body, part);
    }
}
