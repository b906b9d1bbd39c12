package sunbeam.app.scene.mesh;

import java.util.List;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.text.Quoted;

/** Meshes that Sunbeam generates itself, always alike. */
public final class BuiltInMeshes {
    private BuiltInMeshes() {}

    /** The names, in the order in which help shows them. */
    public static List<String> names() {
        return List.of("snake", "plane", "sphere", "cylinder");
    }

    /**
     * Generates a mesh.
     *
     * <ul>
     *   <li>{@code snake}: see {@link SnakeMesh}
     *   <li>{@code plane}: a square of 0.2 m in z = 0 about the origin
     *   <li>{@code sphere}: of radius 0.1 m about the origin
     *   <li>{@code cylinder}: an open mantle of radius 0.1 m about the z axis, from z = 0 to 0.2 m
     * </ul>
     *
     * @throws InputException for any other name
     */
    public static Mesh create(String name) {
        return switch (name) {
            case "snake" -> SnakeMesh.create();
            case "plane" -> SimpleMeshes.plane(0.2, 8);
            case "sphere" -> SimpleMeshes.sphere(0.1, 96, 48);
            case "cylinder" -> SimpleMeshes.cylinder(0.1, 0.2, 96, 24);
            default ->
                throw new InputException("there is no built-in mesh " + Quoted.of(name) + "; choose one of "
                        + String.join(", ", names()));
        };
    }
}
