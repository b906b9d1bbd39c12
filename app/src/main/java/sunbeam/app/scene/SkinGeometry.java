package sunbeam.app.scene;

import java.util.List;
import java.util.Optional;
import jrtr.Faces;
import jrtr.Tile;
import jrtr.gl.ShaderProgram;
import jrtr.gl.VertexBuffer;
import jrtr.scene.Material;
import jrtr.scene.PictureArea;
import jrtr.scene.SceneGraph;
import jrtr.scene.ViewRays;
import org.joml.Quaternionfc;
import org.joml.Vector3fc;

/**
 * All that determines what each pixel of a picture shows before it is lit.
 *
 * @param mesh triangles
 * @param closed whether they enclose a body
 * @param body their textures
 * @param view from where
 * @param orientation as {@link Scene#orientation()}
 * @param rotatePatch as {@link Scene#rotatePatch()}
 * @param shadows of the mesh
 * @param shadowLight towards the light that casts them; empty without
 * @param width pixels per row of the whole picture
 * @param height rows of the whole picture
 */
record SkinGeometry(
        VertexBuffer mesh,
        boolean closed,
        SkinTextures body,
        Viewpoint view,
        Quaternionfc orientation,
        double rotatePatch,
        Shadows shadows,
        Optional<Vector3fc> shadowLight,
        int width,
        int height) {

    /** Towards the viewer from what the pixels of a block show. */
    ViewRays viewRays(Tile block) {
        return ViewRays.of(
                view.camera(), SceneGraphs.frustum(view, mesh.bounds()), new PictureArea(width, height, block));
    }

    /**
     * For a {@linkplain GeometryLayout#shader() program} that notes it.
     *
     * @param shadowTaps compared places of the map of shadows
     */
    SceneGraph graph(ShaderProgram program, int shadowTaps) {
        Faces faces = closed && SceneGraphs.seesFromOutside(view, mesh.bounds()) ? Faces.FRONT : Faces.BOTH;
        shadows.applyTo(program, shadowLight.isPresent() ? shadowTaps : 0);
        Material material = body.material(program, rotatePatch, faces, List.of(shadows.binding()));
        return SceneGraphs.unlit(view, orientation, mesh, material);
    }
}
