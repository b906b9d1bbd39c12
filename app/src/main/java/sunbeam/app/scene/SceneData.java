package sunbeam.app.scene;

import java.util.Optional;
import sunbeam.app.mesh.Mesh;
import sunbeam.app.setup.MethodFactory;
import sunbeam.app.texture.BodyTexture;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.table.FourierTable;

/**
 * A scene and what it names, loaded and computed: all that a session uploads. Parts that two of these share are the same
 * objects.
 *
 * @param scene what was asked for
 * @param mesh its triangles
 * @param patch its nanostructure
 * @param method how that is evaluated, for every pair of directions
 * @param table the Fourier table of the method's plan, for methods that have one
 * @param body its texture
 */
public record SceneData(
        Scene scene, Mesh mesh, Patch patch, MethodFactory method, Optional<FourierTable> table, BodyTexture body) {

    /** Whether another scene can be drawn with these parts: only light, camera, weights and the like differ. */
    public boolean suits(Scene other) {
        return scene.mesh().equals(other.mesh())
                && scene.patch().equals(other.patch())
                && scene.texture().equals(other.texture())
                && scene.method().method().equals(other.method().method());
    }

    /**
     * The same parts for another scene.
     *
     * @throws IllegalArgumentException unless they suit it
     */
    public SceneData with(Scene other) {
        if (!suits(other)) {
            throw new IllegalArgumentException(
                    "a scene with another mesh, patch, texture or method must be loaded by a SceneLoader");
        }
        return new SceneData(other, mesh, patch, method, table, body);
    }

    // The same object, not an equal one: comparing the values would take as long as loading them.

    @SuppressWarnings("ReferenceEquality")
    boolean sharesMesh(SceneData other) {
        return mesh == other.mesh;
    }

    @SuppressWarnings("ReferenceEquality")
    boolean sharesBody(SceneData other) {
        return body == other.body;
    }

    @SuppressWarnings("ReferenceEquality")
    boolean sharesMethod(SceneData other) {
        return method == other.method;
    }
}
