package sunbeam.app.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.texture.Body;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.shader.ShaderTables;

/**
 * A scene and what it names, loaded and computed: all that a session uploads. Parts that two of these share are the same
 * objects.
 *
 * @param scene what was asked for
 * @param mesh its triangles
 * @param sky how much of the sky these see; may take a moment
 * @param region number of the patch that method and tables are for, among the scene's
 * @param patch that nanostructure
 * @param method how that is evaluated, for every pair of directions
 * @param tables what its shader reads
 * @param levels by what its colors are made as pixels look into them, where the method's are
 * @param body its texture and scales, and where the patch is
 * @param part of the skin's light that method and tables are for; all of it where the index is the same at all wavelengths
 */
public record SceneData(
        Scene scene,
        Mesh mesh,
        Supplier<SkyVisibility> sky,
        int region,
        Patch patch,
        MethodPlan method,
        ShaderTables tables,
        Optional<LevelBakers> levels,
        Body body,
        Optional<SkinPart> part) {

    /** Whether another scene can be drawn with these parts: only light, camera, weights and the like differ. */
    public boolean suits(Scene other) {
        return scene.sharesParts(other);
    }

    /**
     * The same parts for another scene; this for an equal one.
     *
     * @throws IllegalArgumentException unless they suit it
     */
    public SceneData with(Scene other) {
        if (!suits(other)) {
            throw new IllegalArgumentException(
                    "a scene with another mesh, patch, texture or method must be loaded by a SceneLoader");
        }
        return other.equals(scene)
                ? this
                : new SceneData(other, mesh, sky, region, patch, method, tables, levels, body, part);
    }

    /** Something of each patch, from all parts of a scene, in their order. */
    public static <T> List<T> ofRegions(List<SceneData> parts, Function<SceneData, T> found) {
        List<T> all = new ArrayList<>();
        for (SceneData part : parts) {
            if (part.region() == all.size()) {
                all.add(found.apply(part));
            }
        }
        return all;
    }

    /** Whether method and tables are the same objects: comparing the values would take as long as loading them. */
    @SuppressWarnings("ReferenceEquality")
    boolean sharesMethod(SceneData other) {
        return method == other.method;
    }
}
