package sunbeam.app.render;

import java.util.List;
import java.util.function.Supplier;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.texture.Body;

/**
 * Data of a scene without its diffraction, whose data take longer to load.
 *
 * @param sky visible share of the sky; computed on first use
 * @param bodies texture, scales and orientations of the mesh, each with the area of one patch
 */
public record SceneShape(Mesh mesh, Supplier<SkyVisibility> sky, List<Body> bodies) {}
