package sunbeam.app.render;

import java.util.List;
import java.util.function.Supplier;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.texture.Body;

/**
 * What a scene shows but for its diffraction, which takes longer to load.
 *
 * @param mesh its triangles
 * @param sky how much of the sky these see; may take a moment
 * @param bodies for each patch, texture and scales, and where the patch is
 */
public record SceneShape(Mesh mesh, Supplier<SkyVisibility> sky, List<Body> bodies) {}
