package sunbeam.app.render;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSharing;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.setting.Choices;

/**
 * Input of a {@link SceneSession} for one look, one patch and one reflectance component. A scene's parts share meshes, sky and textures, and
 * parts with equal tables share these.
 *
 * @param scene scene whose current object is the first with the part's look
 * @param shape objects without diffraction, which a scene's parts share
 * @param region index of the patch in that object, to which method and tables belong
 * @param method plan for every pair of directions
 * @param bakers bakers of the color table's tiles; empty for methods without one
 * @param reflectanceComponent component of method and tables; empty for an index that is the same at all wavelengths
 */
public record SceneData(
        Scene scene,
        SceneShape shape,
        int region,
        Patch patch,
        MethodPlan method,
        ShaderTables tables,
        Optional<LevelBakers> bakers,
        Optional<ReflectanceComponent> reflectanceComponent) {

    /** Returns the scene; under an environment, its light is the brightest one of that. */
    public Scene lit() {
        return shape.environment()
                .map(map -> scene.withLight(LightList.brightest(scene, map)))
                .orElse(scene);
    }

    /** Returns the index of the first object with the part's look. */
    public int look() {
        return scene.current();
    }

    /** True if this part draws light of a patch of one of the scene's objects. */
    public boolean draws(int object, int regionOfObject) {
        return region == regionOfObject && scene.looks().get(object) == look();
    }

    /** Returns the number of a patch in the geometry pass (shaders/geometry.frag), from 1. */
    static int patchNumber(int look, int region) {
        return 1 + PatchAtlas.MOST * look + region;
    }

    /** Returns notes and warnings about a patch, and about its size under the scene's method: one line each, with its name. */
    public static List<String> patchRemarks(Scene scene, Patch patch) {
        Choices choices = scene.method().choices();
        Optional<String> limit =
                ScanLimit.of(choices, patch).line().map(line -> line.in(choices.origin(COHERENCE_LENGTH)));
        return Stream.of(patch.notes().stream(), patch.warning().stream(), limit.stream())
                .flatMap(lines -> lines)
                .map(line -> patch.name() + ": " + line)
                .toList();
    }

    /** True if another scene differs only in light, camera, weights and other settings that need no loading. */
    public boolean suits(Scene other) {
        return SceneSharing.sharesParts(scene, other);
    }

    /** Returns the same data for another scene. Throws IllegalArgumentException unless {@link #suits} allows it. */
    public SceneData with(Scene other) {
        if (!suits(other)) {
            throw new IllegalArgumentException(
                    "a scene with another mesh, patch, texture or method must be loaded by a SceneLoader");
        }
        return other.at(look()).equals(scene) ? this : with(other, shape);
    }

    SceneData with(Scene other, SceneShape otherShape) {
        Scene own = other.at(look());
        return new SceneData(own, otherShape, region, patch, method, tables, bakers, reflectanceComponent);
    }

    /** Returns one value for each patch of each look of a scene, in order. */
    public static <T> List<T> ofRegions(List<SceneData> parts, Function<SceneData, T> value) {
        Map<List<Integer>, T> all = new LinkedHashMap<>();
        parts.forEach(part -> all.putIfAbsent(List.of(part.look(), part.region()), value.apply(part)));
        return List.copyOf(all.values());
    }

    /** Compares objects: comparing values would take as long as loading them. */
    boolean sharesMethod(SceneData other) {
        return SceneSharing.isSame(method, other.method);
    }

    /**
     * Component of the reflectance of a skin with an index by wavelength: a product of one function of wavelength and one of direction. The
     * diffracted light is the sum over the components.
     *
     * @param reflection spectral factor of the light and weights of Schlick's two terms
     * @param digest hash of the index over the visible wavelengths
     */
    public record ReflectanceComponent(ReflectionPart reflection, String digest) {

        /** Equal for components with equal tables. */
        List<Object> identity() {
            return List.of(digest, reflection.constant(), reflection.schlick());
        }

        static List<ReflectanceComponent> of(RefractiveIndex index, CieTable cie) {
            float[] reflectances = new float[401];
            IntStream.range(0, reflectances.length)
                    .forEach(i -> reflectances[i] = (float) index.reflectance((CieTable.FIRST_NANOMETER + i) * 1e-9));
            String digest = new Sha256().add(reflectances).hex();
            return ReflectionPart.of(index, cie, 1).stream()
                    .map(part -> new ReflectanceComponent(part, digest))
                    .toList();
        }
    }
}
